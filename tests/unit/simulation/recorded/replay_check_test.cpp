// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/recorded/replay_check.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"
#include "support/worlds/robot_presets.hpp"

namespace fairway {
namespace {

// Two robots that meet, and a person in their path.
Scenario meeting() {
  Scenario scenario;
  scenario.map =
      OccupancyGrid(GridFrame{.width = 200, .height = 80, .resolution = 0.05, .origin = {}});
  for (int y = 0; y < 30; ++y)
    scenario.map.set({.x = 100, .y = y}, CellState::Occupied);
  scenario.robots = {{.name = "one",
                      .start = {.position = {1.0, 1.0}, .heading = 0.0},
                      .goal = {.position = {9.0, 1.0}, .heading = {}}},
                     {.name = "two",
                      .start = {.position = {9.0, 3.0}, .heading = 3.0},
                      .goal = {.position = {1.0, 3.0}, .heading = {}}}};
  scenario.bodies = {
      {.name = "person",
       .radius = 0.3,
       .key_frames = {{.time = 0.0, .position = {3.0, 3.5}}, {.time = 6.0, .position = {3.0, 0.5}}},
       .loop = false}};
  scenario.time_limit = 20.0;
  return scenario;
}

// Passes all events on, but changes the answer of one cycle.
class Forger final : public EpisodeObserver {
 public:
  explicit Forger(EpisodeObserver& to) : to_(to) {}
  void on_start(const Scenario& scenario) override { to_.on_start(scenario); }
  void on_navigators(double time,
                     const Settings& settings,
                     std::span<const NavigatorStart> starts) override {
    to_.on_navigators(time, settings, starts);
  }
  void on_plan(double time, std::size_t robot, const Plan& plan) override {
    to_.on_plan(time, robot, plan);
  }
  void on_world(const WorldView& world) override { to_.on_world(world); }
  void on_cycle(const NavigationCycle& cycle) override {
    NavigationCycle forged = cycle;
    if (++count_ == 17) {
      forged.step.command.linear = std::nextafter(forged.step.command.linear, 10.0);
      time_ = cycle.input.time;
    }
    to_.on_cycle(forged);
  }
  [[nodiscard]] double time() const { return time_; }

 private:
  EpisodeObserver& to_;
  int count_ = 0;
  double time_ = 0.0;
};

TEST(ReplayCheck, ReproducesEveryCommandOfARun) {
  ReplayCheck check;
  const EpisodeResult result = run_episode(meeting(), {.observer = &check});
  EXPECT_EQ(check.cycles(), result.robots[0].cycles + result.robots[1].cycles);
  EXPECT_GT(check.cycles(), 100);
  EXPECT_EQ(check.different(), 0);
  EXPECT_FALSE(check.first_difference());
}

TEST(ReplayCheck, ReproducesARobotWithALidarFromItsScansAndPoses) {
  Scenario scenario = meeting();
  scenario.sensing.sensing = Sensing::Lidar;
  scenario.sensing.lidar.beams = 180;
  use_standard_noise(scenario.sensing);
  ReplayCheck check;
  const EpisodeResult result = run_episode(scenario, {.observer = &check});
  EXPECT_EQ(check.cycles(), result.robots[0].cycles + result.robots[1].cycles);
  EXPECT_GT(check.cycles(), 100);
  EXPECT_EQ(check.different(), 0);
}

// Their plans are not in a recording: they are made again.
TEST(ReplayCheck, ReproducesRobotsWithABody) {
  for (const Sensing sensing : {Sensing::Map, Sensing::Lidar}) {
    Scenario scenario = meeting();
    scenario.sensing.sensing = sensing;
    scenario.sensing.lidar.beams = 180;
    scenario.robots[0].model = test::robot_presets()[0].model;
    scenario.robots[1].model = test::robot_presets()[2].model;
    if (sensing == Sensing::Lidar) scenario.robots.resize(1);
    describe_models(scenario);
    ReplayCheck check;
    const EpisodeResult result = run_episode(scenario, {.observer = &check});
    int cycles = 0;
    for (const RobotResult& robot : result.robots)
      cycles += robot.cycles;
    EXPECT_EQ(check.cycles(), cycles);
    // By lidar the person walks into the robot, which has stopped for them.
    EXPECT_GT(check.cycles(), 20);
    EXPECT_EQ(result.robots[0].approach, 0.0);
    EXPECT_EQ(check.different(), 0)
        << check.first_difference()->time << " s, robot " << check.first_difference()->robot;
  }
}

// Plans from a thread arrive in cycles that depend on the machine; the recording has these cycles.
TEST(ReplayCheck, ReproducesARunWithPlansFromAThread) {
  for (const Sensing sensing : {Sensing::Map, Sensing::Lidar}) {
    Scenario scenario = meeting();
    scenario.settings.planning.background = true;
    scenario.sensing.sensing = sensing;
    scenario.sensing.lidar.beams = 180;
    scenario.time_limit = 60.0;
    ReplayCheck check;
    const EpisodeResult result = run_episode(scenario, {.observer = &check});
    EXPECT_EQ(check.cycles(), result.robots[0].cycles + result.robots[1].cycles);
    EXPECT_EQ(check.different(), 0);
  }
}

// The run is changed: another goal, other settings, a wall that is not announced.
TEST(ReplayCheck, ReproducesARobotWithALidarThroughAllChanges) {
  Scenario scenario = meeting();
  scenario.robots.resize(1);
  scenario.sensing.sensing = Sensing::Lidar;
  scenario.sensing.lidar.beams = 180;
  ReplayCheck check;
  int cycles = 0;
  const auto play = [&](EpisodeControl& control) {
    ++cycles;
    if (cycles == 20) control.set_goal(0, {.position = {5.0, 3.0}, .heading = {}});
    if (cycles == 25) control.set_cells(std::vector<CellIndex>(1, {.x = 90, .y = 50}), true);
    if (cycles == 30) {
      Settings slower = scenario.settings;
      slower.robot.linear_max = 0.5;
      control.set_settings(slower);
    }
    return cycles < 90;
  };
  static_cast<void>(run_episode(scenario, {.observer = &check, .play = play}));
  EXPECT_GT(check.cycles(), 50);
  EXPECT_EQ(check.different(), 0);
}

TEST(ReplayCheck, DetectsTheLastBitOfOneCommand) {
  ReplayCheck check;
  Forger forger(check);
  static_cast<void>(run_episode(meeting(), {.observer = &forger}));
  EXPECT_EQ(check.different(), 1);
  ASSERT_TRUE(check.first_difference());
  EXPECT_EQ(check.first_difference()->time, forger.time());
  EXPECT_GT(check.first_difference()->recorded.command.linear,
            check.first_difference()->replayed.command.linear);
}

}  // namespace
}  // namespace fairway
