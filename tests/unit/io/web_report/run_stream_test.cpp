// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/web_report/run_stream.hpp"

#include <gtest/gtest.h>

#include "fairway/io/web_report/report.hpp"
#include "fairway/simulation/episode.hpp"
#include "unit/io/recording/synthetic_run.hpp"

namespace fairway::io {
namespace {

using test::SyntheticRun;

// Reads numbers like the page; the browser tests check the meaning of records.
std::uint64_t take_count(std::string_view& bytes) {
  std::uint64_t value = 0;
  for (int shift = 0; !bytes.empty(); shift += 7) {
    const auto byte = static_cast<std::uint8_t>(bytes.front());
    bytes.remove_prefix(1);
    value |= static_cast<std::uint64_t>(byte & 127U) << shift;
    if (byte < 128) return value;
  }
  ADD_FAILURE() << "a number is truncated";
  return 0;
}

// Counts the records of each kind.
std::vector<int> kinds(std::string_view records) {
  std::vector<int> counts(9);
  while (!records.empty()) {
    const auto kind = take_count(records);
    const std::uint64_t size = take_count(records);
    if (kind >= counts.size() || size > records.size()) {
      ADD_FAILURE() << "not a record";
      break;
    }
    records.remove_prefix(size);
    ++counts[kind];
  }
  return counts;
}

TEST(RunStream, IsACompleteListOfRecords) {
  const SyntheticRun run{.robots = 3, .bodies = 1, .seconds = 2.0};
  RunStream stream;
  run.play(stream);
  EXPECT_EQ(kinds(stream.take()), (std::vector<int>{0, 1, 3, 3, 63, 21, 1, 0, 0}));
}

TEST(RunStream, StartsForALateViewerWithMapsPlansAndTheNewestTimeStep) {
  const SyntheticRun run{.robots = 3, .bodies = 1, .seconds = 2.0};
  RunStream stream;
  run.play(stream);
  EXPECT_EQ(kinds(stream.beginning(2.0)), (std::vector<int>{0, 1, 2, 3, 3, 1, 1, 0, 0}));
}

// The lidar scans twice in a cycle; only the last scan can be displayed.
TEST(RunStream, WritesOneScanPerCycleAndOneGoal) {
  Scenario scenario;
  scenario.map =
      OccupancyGrid(GridFrame{.width = 80, .height = 40, .resolution = 0.1, .origin = {}});
  scenario.robots = {{.name = "one",
                      .start = {.position = {1.0, 1.0}, .heading = 0.3},
                      .goal = {.position = {7.0, 2.0}, .heading = {}}}};
  scenario.sensing.sensing = Sensing::Lidar;
  scenario.sensing.lidar.beams = 90;
  scenario.time_limit = 2.0;
  RunStream stream;
  const EpisodeResult result = run_episode(scenario, {.observer = &stream});
  const std::vector<int> counts = kinds(stream.take());
  EXPECT_EQ(counts[4], result.robots[0].cycles);
  EXPECT_EQ(counts[7], result.robots[0].cycles);
  EXPECT_EQ(counts[8], 1);
  EXPECT_EQ(kinds(stream.beginning(2.0))[7], 1);
}

TEST(RunStream, IsTheSameInPieces) {
  const SyntheticRun run;
  RunStream whole;
  run.play(whole);
  const std::string all = whole.take();
  EXPECT_FALSE(all.empty());
  EXPECT_TRUE(whole.take().empty());
  RunStream again;
  run.play(again);
  EXPECT_EQ(again.take(), all);
}

TEST(Report, OfFiveMinutesOfFourRobotsIsBelowTenMegabytes) {
  Report report;
  SyntheticRun{.robots = 4, .bodies = 6, .seconds = 300.0, .map_side = 1000}.play(
      report.observer());
  const std::string page = report.page();
  EXPECT_LT(page.size(), 10'000'000U);
  RecordProperty("bytes", static_cast<int>(page.size()));
}

TEST(Report, IsSelfContained) {
  Report report;
  SyntheticRun{.seconds = 1.0}.play(report.observer());
  const std::string page = report.page();
  for (const char* reference : {"src=\"", "href=\"http", "@import", "url(http"})
    EXPECT_EQ(page.find(reference), std::string::npos) << reference;
}

}  // namespace
}  // namespace fairway::io
