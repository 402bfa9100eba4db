// SPDX-License-Identifier: Apache-2.0
// Modified recordings are refused with a reason, or played. Found by tests/fuzz.
#include "support/runs/changed_recording.hpp"

#include <gtest/gtest.h>

#include "fairway/io/recording/exact/exact_json.hpp"
#include "fairway/io/recording/reading/recording_reader.hpp"
#include "fairway/io/recording/recording.hpp"
#include "fairway/io/web_report/run_stream.hpp"
#include "fairway/simulation/recorded/observer_list.hpp"
#include "fairway/simulation/recorded/replay_check.hpp"
#include "support/random/random_world.hpp"

namespace fairway::io {
namespace {

using test::ChangedRecording;

// Reads it like `fairway replay --report`.
Expected<void> read(const ChangedRecording& recording) {
  ReplayCheck check;
  RunStream stream;
  ObserverList observers;
  observers.add(check);
  observers.add(stream);
  return read_recording(recording.bytes(), "r.mcap", observers);
}

void expect_refused(const ChangedRecording& recording, const std::string& part) {
  const Expected<void> done = read(recording);
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().message.find(part), std::string::npos) << done.error().message;
  EXPECT_EQ(done.error().message.find('\n'), std::string::npos);
}

TEST(ChangedRecording, IsReadWithoutAChange) {
  for (const Sensing sensing : {Sensing::Map, Sensing::Lidar})
    EXPECT_TRUE(read(test::short_recording(sensing)));
}

TEST(ChangedRecording, IsRefusedWhereTheWorldHasAnotherFrame) {
  ChangedRecording recording = test::short_recording(Sensing::Map);
  BitGrid other(GridFrame{.width = 3, .height = 2, .resolution = 0.1, .origin = {}}, false);
  recording.first("fairway.Cells")["grid"] = exact::to_json(other);
  expect_refused(recording, "the scenario's map");
}

// Every value of every message may be another one: the recording is refused, or it is played.
TEST(ChangedRecording, IsReadOrRefusedWhateverValueIsChanged) {
  using Json = ChangedRecording::Json;
  const std::vector<Json> values{nullptr, -1,          1e308, "NaN",         1'000'000'007,
                                 "",      "-Infinity", false, Json::array(), Json::object(),
                                 1e-308,  1e9};
  test::Random random(11);
  int refused = 0;
  for (const Sensing sensing : {Sensing::Map, Sensing::Lidar}) {
    const ChangedRecording good = test::short_recording(sensing);
    for (int trial = 0; trial < 600; ++trial) {
      ChangedRecording bad = good;
      const int last = static_cast<int>(bad.messages.size()) - 1;
      Json& content = bad.messages[static_cast<std::size_t>(random.integer(0, last))].content;
      const Json flat = content.flatten();
      const auto place =
          std::next(flat.begin(), random.integer(0, static_cast<int>(flat.size()) - 1));
      content[Json::json_pointer(place.key())] =
          values[static_cast<std::size_t>(random.integer(0, static_cast<int>(values.size()) - 1))];
      if (const auto done = read(bad); !done) {
        ++refused;
        EXPECT_EQ(done.error().message.find('\n'), std::string::npos) << done.error().message;
      }
    }
  }
  EXPECT_GT(refused, 400);
}

TEST(ChangedRecording, IsRefusedWhereARectangleDoesNotMeetTheNext) {
  ChangedRecording recording = test::short_recording(Sensing::Map);
  auto& rectangles = recording.first("fairway.Plan")["plan"]["rectangles"];
  rectangles.push_back(rectangles.back());
  rectangles.back()["seed"] = {500.0, 500.0};
  expect_refused(recording, "expected an overlap with the one before");
}

// The messages of a topic are numbered: one that was lost, or put in, is noticed.
TEST(ChangedRecording, IsRefusedWhereTheMessagesOfATopicAreNotInOrder) {
  ChangedRecording recording = test::short_recording(Sensing::Map);
  const std::uint16_t first = recording.messages.back().channel;  // numbered again from 0
  recording.channels.push_back(recording.channels[first]);
  recording.messages.back().channel = static_cast<std::uint16_t>(recording.channels.size() - 1);
  expect_refused(recording, ", found 0");
}

TEST(ChangedRecording, IsRefusedBeforeMemoryIsAllocatedForAMissingMap) {
  ChangedRecording recording = test::short_recording(Sensing::Map);
  auto& frame = recording.first("fairway.Scenario")["frame"];
  frame["width"] = 32768;
  frame["height"] = 32768;
  expect_refused(recording, "as many cells");
}

}  // namespace
}  // namespace fairway::io
