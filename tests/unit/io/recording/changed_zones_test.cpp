// SPDX-License-Identifier: Apache-2.0
// Zones that change during a run are recorded, obeyed and replayed.
#include <gtest/gtest.h>

#include "fairway/io/recording/reading/recording_reader.hpp"
#include "fairway/io/recording/recording.hpp"
#include "fairway/io/web_report/run_stream.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/recorded/replay_check.hpp"

namespace fairway::io {
namespace {

Scenario hall_scenario(Sensing sensing) {
  Scenario scenario;
  scenario.map =
      OccupancyGrid(GridFrame{.width = 240, .height = 80, .resolution = 0.05, .origin = {}});
  scenario.robots = {{.name = "robot 1",
                      .start = {.position = {1.0, 2.0}, .heading = 0.0},
                      .goal = {.position = {11.0, 2.0}, .heading = {}}}};
  scenario.sensing.sensing = sensing;
  return scenario;
}

Zone slow_hall() {
  return {.kind = ZoneKind::SpeedLimit,
          .polygon = {{4.0, 0.0}, {8.0, 0.0}, {8.0, 4.0}, {4.0, 4.0}},
          .speed = 0.2};
}

class ChangedZones : public ::testing::TestWithParam<Sensing> {};

TEST_P(ChangedZones, AreObeyedAndReplayed) {
  const Scenario scenario = hall_scenario(GetParam());
  Recording recording;
  RunMessages messages(recording);
  constexpr int kAdded = 10;     // cycle
  constexpr int kRemoved = 120;  // cycle, while the robot is in the zone
  int cycle = 0;
  double fastest_in_zone = 0.0;
  double fastest_after = 0.0;
  const auto play = [&](EpisodeControl& control) {
    const UnicycleRobot& robot = control.world().robots()[0];
    const bool inside = robot.pose.position.x() > 4.0 && robot.pose.position.x() < 8.0;
    if (inside && cycle <= kRemoved)
      fastest_in_zone = std::max(fastest_in_zone, robot.twist.linear);
    if (cycle > kRemoved) fastest_after = std::max(fastest_after, robot.twist.linear);
    if (cycle == kAdded) control.set_zones({slow_hall()});
    if (cycle == kRemoved) {
      EXPECT_TRUE(inside);
      control.set_zones({});
    }
    return ++cycle < 200;
  };
  static_cast<void>(run_episode(scenario, {.observer = &messages, .play = play}));
  EXPECT_GT(fastest_in_zone, 0.1);
  EXPECT_LE(fastest_in_zone, 0.2 + 1e-9);
  EXPECT_GT(fastest_after, 0.5);
  recording.finish();
  const std::string bytes = recording.take();
  ReplayCheck check;
  const auto read = read_recording(bytes, "run.mcap", check);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_GT(check.cycles(), 100);
  EXPECT_EQ(check.different(), 0);
  Recording again;
  RunMessages once_more(again);
  ASSERT_TRUE(read_recording(bytes, "run.mcap", once_more));
  again.finish();
  EXPECT_EQ(again.take(), bytes);
}

INSTANTIATE_TEST_SUITE_P(Senses,
                         ChangedZones,
                         ::testing::Values(Sensing::Map, Sensing::Lidar),
                         [](const auto& sensing) {
                           return sensing.param == Sensing::Map ? "Map" : "Lidar";
                         });

// A viewer that joins a paused world has its zones, its cycles and the place of its robots.
TEST(RunStream, BeginsWithTheNewestZonesAndCycles) {
  const Scenario scenario = hall_scenario(Sensing::Map);
  RunStream stream;
  const auto play = [&](EpisodeControl& control) {
    control.set_zones({slow_hall()});
    const std::string before = stream.beginning(control.world().time());
    stream.tell_paused_world(control);
    // Only the numbers of the world differ: a cycle has many more bytes than that.
    EXPECT_NEAR(static_cast<double>(stream.beginning(control.world().time()).size()),
                static_cast<double>(before.size()), 8.0);
    EXPECT_NE(before.find("speed_limit"), std::string::npos);
    return false;
  };
  static_cast<void>(run_episode(scenario, {.observer = &stream, .play = play}));
}

}  // namespace
}  // namespace fairway::io
