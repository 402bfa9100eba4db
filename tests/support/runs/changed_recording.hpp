// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "fairway/io/recording/run_messages.hpp"
#include "fairway/simulation/episode.hpp"

namespace fairway::test {

/// The recording of a short run, to be changed before it is read.
struct ChangedRecording {
  using Json = nlohmann::json;

  struct Message {
    std::uint16_t channel = 0;
    Json content;
  };

  std::vector<io::McapChannel> channels;
  std::vector<Message> messages;  ///< the messages that are read again

  /// The first message of a schema. @pre there is one.
  [[nodiscard]] Json& first(const std::string& schema) {
    const auto found = std::find_if(messages.begin(), messages.end(), [&](const Message& message) {
      return channels[message.channel].schema_name == schema;
    });
    return found->content;
  }

  /// All messages as a file.
  [[nodiscard]] std::string bytes() const {
    io::McapWriter writer;
    for (const io::McapChannel& channel : channels)
      writer.add_channel(channel);
    for (const Message& message : messages) {
      writer.write(message.channel, 0,
                   message.content.dump(-1, ' ', false, Json::error_handler_t::replace));
    }
    writer.finish();
    return writer.take();
  }
};

/// Two robots that publish their motions and meet a person, for three cycles.
inline Scenario short_scenario(Sensing sensing) {
  Scenario scenario;
  scenario.map = OccupancyGrid({.width = 30, .height = 20, .resolution = 0.2, .origin = {}});
  for (int y = 0; y < 12; ++y)
    scenario.map.set({15, y}, CellState::Occupied);
  scenario.robots = {{.name = "a", .start = {.position = {1, 1}}, .goal = {.position = {5, 1}}},
                     {.name = "b", .start = {.position = {5, 2}}, .goal = {.position = {1, 2}}}};
  scenario.bodies = {{.name = "p", .key_frames = {{0.0, {2, 3}}, {2.0, {3, 3}}}}};
  scenario.settings.perception.window = 4.0;
  scenario.settings.perception.resolution = 0.2;
  scenario.sensing.sensing = sensing;
  scenario.sensing.lidar.beams = 24;
  scenario.radio.on = true;
  return scenario;
}

/// The recording of `short_scenario`.
inline ChangedRecording short_recording(Sensing sensing) {
  class Collector final : public io::MessageSink {
   public:
    std::uint16_t add_channel(const io::McapChannel& channel) override {
      kept.channels.push_back(channel);
      return static_cast<std::uint16_t>(kept.channels.size() - 1);
    }
    [[nodiscard]] bool wants(std::uint16_t channel) const override {
      const std::string& schema = kept.channels[channel].schema_name;
      return schema.starts_with("fairway.") || schema == "foxglove.LaserScan" ||
             kept.channels[channel].topic == "/map";
    }
    void write(std::uint16_t channel, std::uint64_t /*time*/, std::string_view message) override {
      if (!wants(channel)) return;
      kept.messages.push_back(
          {.channel = channel, .content = ChangedRecording::Json::parse(message)});
    }
    ChangedRecording kept;
  };
  Collector collector;
  io::RunMessages messages(collector);
  int cycles = 0;
  static_cast<void>(run_episode(short_scenario(sensing),
                                {.clock = {},
                                 .on_cycle = [&](double /*time*/) { return ++cycles < 3; },
                                 .observer = &messages,
                                 .play = {}}));
  return collector.kept;
}

}  // namespace fairway::test
