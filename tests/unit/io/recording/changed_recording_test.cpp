// SPDX-License-Identifier: Apache-2.0
// Modified recordings are refused with a reason, or played. Found by tests/fuzz.
#include "support/changed_recording.hpp"

#include <gtest/gtest.h>

#include "fairway/io/recording/exact_json.hpp"
#include "fairway/io/recording/reading/recording_reader.hpp"
#include "fairway/io/recording/recording.hpp"
#include "fairway/io/web_report/run_stream.hpp"
#include "fairway/simulation/recorded/observer_list.hpp"
#include "fairway/simulation/recorded/replay_check.hpp"

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

TEST(ChangedRecording, IsRefusedBeforeMemoryForAMissingMapIsAllocated) {
  ChangedRecording recording = test::short_recording(Sensing::Map);
  auto& frame = recording.first("fairway.Scenario")["frame"];
  frame["width"] = 32768;
  frame["height"] = 32768;
  expect_refused(recording, "as many cells");
}

}  // namespace
}  // namespace fairway::io
