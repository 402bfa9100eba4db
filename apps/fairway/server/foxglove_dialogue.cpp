// SPDX-License-Identifier: Apache-2.0
#include "server/foxglove_dialogue.hpp"

#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace fairway::app {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostSubscriptions = 1000;  // of one viewer

// A message: opcode 1, number of the subscription, time, content.
std::shared_ptr<const std::string> data_message(std::uint32_t subscription,
                                                const LiveMessages::Message& message) {
  std::string bytes(1, '\x01');
  for (int i = 0; i < 4; ++i)
    bytes.push_back(static_cast<char>(subscription >> (8 * i) & 0xFFU));
  for (int i = 0; i < 8; ++i)
    bytes.push_back(static_cast<char>(message.time >> (8 * i) & 0xFFU));
  return shared(bytes.append(message.content));
}

}  // namespace

Json FoxgloveDialogue::advertisement(std::uint32_t id, const Channel& channel) {
  return {{"id", id},
          {"topic", channel.described.topic},
          {"encoding", "json"},
          {"schemaName", channel.described.schema_name},
          {"schema", channel.described.schema},
          {"schemaEncoding", "jsonschema"}};
}

void FoxgloveDialogue::on_open(Connection& connection) {
  viewers_[&connection];
  connection.send(
      shared(
          Json{{"op", "serverInfo"}, {"name", "fairway"}, {"capabilities", Json::array()}}.dump()),
      false);
  if (channels_.empty()) return;  // the first run is about to begin
  Json list = Json::array();
  for (const auto& [id, channel] : channels_)
    list.push_back(advertisement(id, channel));
  connection.send(shared(Json{{"op", "advertise"}, {"channels", std::move(list)}}.dump()), false);
}

void FoxgloveDialogue::on_closed(Connection& connection) { viewers_.erase(&connection); }

void FoxgloveDialogue::on_message(Connection& connection, std::string_view message, bool binary) {
  if (binary) return;  // clients may publish in binary; their messages are ignored
  try {
    const Json json = Json::parse(message);
    const auto& op = json.at("op").get_ref<const std::string&>();
    if (op == "subscribe") subscribe(connection, json.at("subscriptions"));
    if (op == "unsubscribe") unsubscribe(connection, json.at("subscriptionIds"));
  } catch (const Json::exception& error) {
    constexpr int kError = 2;
    connection.send(
        shared(Json{{"op", "status"}, {"level", kError}, {"message", error.what()}}.dump(
            -1, ' ', false, Json::error_handler_t::replace)),
        false);
  }
}

void FoxgloveDialogue::subscribe(Connection& connection, const Json& list) {
  for (const Json& item : list) {
    const auto number = item.at("id").get<std::uint32_t>();
    const auto id = item.at("channelId").get<std::uint32_t>();
    Subscriptions& subscriptions = viewers_[&connection];
    const auto channel = channels_.find(id);
    if (channel == channels_.end() || subscriptions.size() >= kMostSubscriptions) continue;
    subscriptions[number] = id;
    const LiveMessages::Message& last = channel->second.last;
    if (!last.content.empty()) connection.send(data_message(number, last), true);
  }
}

void FoxgloveDialogue::unsubscribe(Connection& connection, const Json& list) {
  for (const Json& number : list)
    viewers_[&connection].erase(number.get<std::uint32_t>());
}

void FoxgloveDialogue::tell_all(const Json& json) {
  const auto message = shared(json.dump());
  for (const auto& [viewer, subscriptions] : viewers_)
    viewer->send(message, false);
}

// A new run has its own channels; those of the run before are removed.
void FoxgloveDialogue::replace_channels(LiveMessages::Batch& batch) {
  if (batch.begins_run && !channels_.empty()) {
    Json gone = Json::array();
    for (const auto& [id, channel] : channels_)
      gone.push_back(id);
    channels_.clear();
    tell_all({{"op", "unadvertise"}, {"channelIds", std::move(gone)}});
  }
  Json list = Json::array();
  std::uint32_t id = batch.first_channel;
  for (io::McapChannel& described : batch.channels) {
    Channel& channel = channels_[id] = {.described = std::move(described), .last = {}};
    list.push_back(advertisement(id++, channel));
  }
  tell_all({{"op", "advertise"}, {"channels", std::move(list)}});
}

void FoxgloveDialogue::publish(LiveMessages::Batch batch) {
  if (!batch.channels.empty()) replace_channels(batch);
  for (LiveMessages::Message& message : batch.messages) {
    for (const auto& [viewer, subscriptions] : viewers_) {
      for (const auto& [number, channel] : subscriptions) {
        if (channel == message.channel) viewer->send(data_message(number, message), true);
      }
    }
    if (const auto channel = channels_.find(message.channel); channel != channels_.end()) {
      channel->second.last = std::move(message);
    }
  }
}

}  // namespace fairway::app
