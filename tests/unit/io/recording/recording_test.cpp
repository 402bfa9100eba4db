// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/recording.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "fairway/io/mcap/mcap_reader.hpp"
#include "fairway/io/recording/exact/exact_json.hpp"
#include "fairway/io/recording/foxglove_json.hpp"
#include "fairway/io/recording/reading/recording_reader.hpp"
#include "fairway/io/web_report/run_stream.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/recorded/replay_check.hpp"
#include "support/random/random_world.hpp"
#include "synthetic_run.hpp"

namespace fairway::io {
namespace {

using test::SyntheticRun;

std::string recorded(const SyntheticRun& run) {
  Recording recording;
  RunMessages messages(recording);
  run.play(messages);
  recording.finish();
  return recording.take();
}

TEST(Recording, ReadsBackExactlyTheSameEvents) {
  const SyntheticRun run;
  const std::string bytes = recorded(run);
  // Events are compared by recording them again.
  Recording again;
  RunMessages messages(again);
  const auto read = read_recording(bytes, "run.mcap", messages);
  ASSERT_TRUE(read) << read.error().message;
  again.finish();
  EXPECT_EQ(again.take(), bytes);
}

// This keeps five minutes of four robots below ten megabytes.
TEST(Recording, OfHalfAMinuteOfFourRobotsIsBelowAMegabyte) {
  const std::string bytes = recorded({.robots = 4, .bodies = 3, .seconds = 30.0, .map_side = 1000});
  EXPECT_LT(bytes.size(), 1'000'000U);
  RecordProperty("bytes", static_cast<int>(bytes.size()));
}

// A robot that detects a wall between itself and its goal with a noisy lidar.
Scenario lidar_scenario() {
  Scenario scenario;
  scenario.map =
      OccupancyGrid(GridFrame{.width = 160, .height = 80, .resolution = 0.05, .origin = {}});
  for (int y = 0; y < 45; ++y)
    scenario.map.set({.x = 80, .y = y}, CellState::Occupied);
  scenario.robots = {{.name = "one",
                      .start = {.position = {1.0, 1.0}, .heading = 0.3},
                      .goal = {.position = {6.5, 1.5}, .heading = {}}}};
  scenario.bodies = {
      {.name = "person",
       .radius = 0.3,
       .key_frames = {{.time = 0.0, .position = {3.0, 3.5}}, {.time = 6.0, .position = {2.0, 2.5}}},
       .loop = true}};
  scenario.sensing.sensing = Sensing::Lidar;
  use_standard_noise(scenario.sensing);
  scenario.time_limit = 8.0;
  return scenario;
}

TEST(Recording, OfARobotWithALidarContainsAllItsInputs) {
  const Scenario scenario = lidar_scenario();
  Recording recording;
  RunMessages messages(recording);
  const EpisodeResult result = run_episode(scenario, {.observer = &messages});
  recording.finish();
  const std::string bytes = recording.take();
  ReplayCheck check;
  const auto read = read_recording(bytes, "run.mcap", check);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(check.cycles(), result.robots[0].cycles);
  EXPECT_GT(check.cycles(), 40);
  EXPECT_EQ(check.different(), 0);
  // Nothing is lost when it is recorded again.
  Recording again;
  RunMessages once_more(again);
  ASSERT_TRUE(read_recording(bytes, "run.mcap", once_more));
  again.finish();
  EXPECT_EQ(again.take(), bytes);
}

TEST(Recording, OfARobotWithALidarWithDamageIsRefusedOrHarmless) {
  Scenario scenario = lidar_scenario();
  scenario.time_limit = 0.5;
  Recording recording;
  RunMessages messages(recording);
  static_cast<void>(run_episode(scenario, {.observer = &messages}));
  recording.finish();
  const std::string bytes = recording.take();
  test::Random random(11);
  for (int trial = 0; trial < 100; ++trial) {
    std::string damaged = bytes;
    const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()) - 1));
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random.integer(0, 7)));
    RunStream stream;
    ReplayCheck check;
    static_cast<void>(read_recording(damaged, "run.mcap", stream));
    static_cast<void>(read_recording(damaged, "run.mcap", check));
  }
}

TEST(FoxgloveLaserScan, KeepsEveryRangeToTheBit) {
  test::Random random(13);
  std::vector<float> ranges = {std::nanf(""), 0.1F, 29.999998F, 1.0F / 3.0F};
  for (int i = 0; i < 2000; ++i)
    ranges.push_back(static_cast<float>(random.uniform(0.1, 30.0)));
  LidarScan scan{.max_range = 30.0, .ranges = ranges};
  const auto json = foxglove::laser_scan(0, scan, "odom");
  const std::vector<float> back = foxglove::ranges_of(exact::Json::parse(json.dump()));
  ASSERT_EQ(back.size(), ranges.size());
  EXPECT_TRUE(std::isnan(back[0]));
  for (std::size_t i = 1; i < back.size(); ++i)
    EXPECT_EQ(back[i], ranges[i]) << i;
}

TEST(FoxgloveLaserScan, GivesABeamWithoutAHitTheLargestRange) {
  const std::vector<float> ranges = {std::numeric_limits<float>::infinity(), 45.0F};
  const LidarScan scan{.max_range = 30.0, .ranges = ranges};
  EXPECT_EQ(foxglove::laser_scan(0, scan, "odom").at("ranges"), (exact::Json{30.0, 30.0}));
}

// Four robots that publish their motions exchange places repeatedly.
TEST(Recording, OfAMinuteOfFourRobotsWithMessagesIsBelowTwoMegabytesAndReplays) {
  Scenario scenario;
  scenario.map =
      OccupancyGrid(GridFrame{.width = 240, .height = 240, .resolution = 0.05, .origin = {}});
  const std::array<Eigen::Vector2d, 4> corners{{{2, 2}, {10, 2}, {10, 10}, {2, 10}}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    scenario.robots.push_back({.name = "robot " + std::to_string(i),
                               .start = {.position = corners[i], .heading = 0.7},
                               .goal = {.position = corners[(i + 2) % 4], .heading = {}}});
  }
  constexpr double kMinute = 60.0;
  constexpr int kShift = 150;  // cycles until they turn back
  int cycle = 0;
  const auto play = [&](EpisodeControl& control) {
    if (++cycle % kShift == 0) {
      const std::size_t on = cycle / kShift % 2 == 0 ? 2 : 0;
      for (std::size_t i = 0; i < corners.size(); ++i)
        control.set_goal(i, {.position = corners[(i + on) % 4], .heading = {}});
    }
    return control.world().time() < kMinute - 1e-6;
  };
  Recording recording;
  RunMessages messages(recording);
  static_cast<void>(run_episode(scenario, {.observer = &messages, .play = play}));
  recording.finish();
  const std::string bytes = recording.take();
  EXPECT_LT(bytes.size(), 2'000'000U);  // this keeps five minutes below ten megabytes
  RecordProperty("bytes", static_cast<int>(bytes.size()));
  ReplayCheck check;
  ASSERT_TRUE(read_recording(bytes, "run.mcap", check));
  EXPECT_GT(check.cycles(), 1000);
  EXPECT_EQ(check.different(), 0);
  RecordProperty("cycles", static_cast<int>(check.cycles()));
}

TEST(Recording, ShowsTheTrueBodiesOfTheRobots) {
  for (const bool rectangular : {false, true}) {
    const std::string bytes = recorded({.seconds = 0.2, .rectangular = rectangular});
    exact::Json scene;
    ASSERT_TRUE(read_mcap(bytes, "run.mcap", [&](const McapMessage& message) -> Expected<void> {
      if (message.topic == "/scene") scene = exact::Json::parse(message.content);
      return {};
    }));
    for (const exact::Json& entity : scene.at("entities")) {
      if (entity.at("id") != "robot_1") continue;
      EXPECT_EQ(entity.at("cylinders").size(), rectangular ? 0U : 1U);
      ASSERT_EQ(entity.at("cubes").size(), rectangular ? 1U : 0U);
      if (rectangular) {
        EXPECT_EQ(entity.at("cubes").at(0).at("size").at("x"), 0.6);
      }
    }
  }
}

TEST(Recording, IsTheSameInPieces) {
  const SyntheticRun run;
  Recording recording;
  RunMessages messages(recording);
  std::string pieces = recording.take();
  run.play(messages);
  pieces += recording.take();
  recording.finish();
  pieces += recording.take();
  EXPECT_EQ(pieces, recorded(run));
}

TEST(Recording, OfAnUnfinishedRunCanBeFinishedAsACopy) {
  Recording recording;
  RunMessages messages(recording);
  SyntheticRun{.seconds = 1.0}.play(messages);
  McapWriter copy = recording.writer();
  copy.finish();
  const std::string so_far = copy.take();
  RunStream stream;
  EXPECT_TRUE(read_recording(so_far, "run.mcap", stream));
}

TEST(Recording, EveryDamagedByteIsDetectedOrHarmless) {
  const std::string bytes = recorded({.robots = 1, .bodies = 1, .seconds = 0.5, .map_side = 20});
  test::Random random(7);
  for (int trial = 0; trial < 300; ++trial) {
    std::string damaged = bytes;
    const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()) - 1));
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random.integer(0, 7)));
    RunStream stream;  // must not crash on any input
    static_cast<void>(read_recording(damaged, "run.mcap", stream));
  }
}

TEST(Recording, ThatIsTruncatedIsReportedAsSuch) {
  const std::string bytes = recorded({});
  for (const double share : {0.0, 0.1, 0.5, 0.9}) {
    RunStream stream;
    const auto size = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
    const auto read = read_recording(bytes.substr(0, size), "run.mcap", stream);
    ASSERT_FALSE(read);
    EXPECT_TRUE(read.error().message.starts_with("run.mcap: expected")) << read.error().message;
  }
}

TEST(ExactJson, KeepsEveryDoubleToTheBit) {
  test::Random random(3);
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<double> values = {0.0, -0.0, 0.1, 1e300, 5e-324, inf, -inf, 1.0 / 3.0};
  for (int i = 0; i < 1000; ++i)
    values.push_back(random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-300.0, 300.0)));
  for (const double value : values) {
    const auto text = exact::to_json(value).dump();
    const double back = exact::to_number(exact::Json::parse(text));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value)) << text;
  }
  EXPECT_TRUE(std::isnan(exact::to_number(exact::to_json(std::nan("")))));
}

TEST(ExactJson, ChangedCellsLeadFromOneGridToTheOther) {
  test::Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const GridFrame frame{.width = random.integer(1, 200),
                          .height = random.integer(1, 20),
                          .resolution = 0.05,
                          .origin = {}};
    BitGrid before(frame, false);
    BitGrid now(frame, false);
    for (int i = 0; i < frame.width * frame.height; ++i) {
      const CellIndex cell{.x = i % frame.width, .y = i / frame.width};
      before.set(cell, random.integer(0, 2) == 0);
      now.set(cell, random.integer(0, 1) == 0);
    }
    exact::change_cells(exact::changed_cells(before, now), before);
    EXPECT_TRUE(exact::changed_cells(before, now).empty());
    const BitGrid copy = exact::to_grid(exact::to_json(now));
    EXPECT_TRUE(exact::changed_cells(copy, now).empty());
  }
}

TEST(ExactJson, RefusesInvalidMaps) {
  const BitGrid grid(GridFrame{.width = 8, .height = 4, .resolution = 0.1, .origin = {}}, false);
  exact::Json json = exact::to_json(grid);
  json["frame"]["width"] = 1000000;
  EXPECT_THROW(static_cast<void>(exact::to_grid(json)), std::invalid_argument);
  json["frame"]["width"] = 9;
  json["bits"] = "AAAA";
  EXPECT_THROW(static_cast<void>(exact::to_grid(json)), std::invalid_argument);
  BitGrid changed = grid;
  for (const char* runs : {"[0,0,65,1]", "[4,0,1,1]", "[0,7,2,1]", "[0,-1,1,1]"}) {
    EXPECT_THROW(exact::change_cells(exact::Json::parse(runs), changed), std::invalid_argument)
        << runs;
  }
}

}  // namespace
}  // namespace fairway::io
