// SPDX-License-Identifier: Apache-2.0
#include "server/live_world.hpp"

#include <atomic>
#include <future>

#include <gtest/gtest.h>

#include "fairway/io/recording/reading/recording_reader.hpp"
#include "fairway/simulation/recorded/replay_check.hpp"

namespace fairway::app {
namespace {

// A world without clients.
LiveListener deaf() {
  return {.on_run = [](std::string) {},
          .on_records = [](std::string) {},
          .on_beginning = [](std::string) {},
          .on_messages = [](LiveMessages::Batch) {},
          .on_state = [](const LiveState&) {},
          .on_notice = [](const std::string&) {}};
}

// The result of a download; the world answers between two cycles.
std::string downloaded(LiveWorld& world, LiveWorld::Download what) {
  std::promise<std::string> promise;
  world.download(what, [&](std::string bytes) { promise.set_value(std::move(bytes)); });
  return promise.get_future().get();
}

TEST(LiveMaps, GiveEveryRobotAPath) {
  Planner planner;
  for (const MapChoice& choice : built_in_maps()) {
    const Scenario scenario = choice.make();
    const PreparedMap map(scenario.map);
    for (const RobotTask& robot : scenario.robots) {
      const Plan plan =
          planner.plan(map, robot.start.position, robot.goal, planner_settings(scenario.settings));
      EXPECT_TRUE(plan.usable()) << choice.name << ": " << plan.reason();
      EXPECT_GT(plan.path.length(), 10.0) << choice.name;
    }
  }
}

TEST(LiveWorld, EndsAtOnceWhetherItRunsOrIsPaused) {
  for (const bool paused : {false, true}) {
    LiveWorld world(built_in_maps(), deaf());
    world.ask(PauseCommand{.paused = paused});
  }
}

TEST(LiveWorld, GoesStepByStepWhilePaused) {
  std::atomic<int> told = 0;
  LiveListener listener = deaf();
  listener.on_records = [&](std::string) { ++told; };
  LiveWorld world(built_in_maps(), listener);
  world.ask(PauseCommand{.paused = true});
  static_cast<void>(downloaded(world, LiveWorld::Download::Scenario));  // now it is paused
  const int before = told;
  for (int i = 0; i < 3; ++i)
    world.ask(StepCommand{});
  while (told < before + 3)
    std::this_thread::yield();
  static_cast<void>(downloaded(world, LiveWorld::Download::Scenario));
  EXPECT_EQ(told, before + 3);
}

TEST(LiveWorld, KeepsTheNewestUploads) {
  LiveState state;  // the last state; read after the world has answered
  LiveListener listener = deaf();
  listener.on_state = [&](const LiveState& now) { state = now; };
  LiveWorld world({built_in_maps().back()}, listener);
  const OccupancyGrid map(GridFrame{.width = 100, .height = 100, .resolution = 0.05, .origin = {}});
  for (int i = 0; i < 20; ++i)
    while (!world.use_map("map " + std::to_string(i), map))
      std::this_thread::yield();
  // One run for each, and one more answer from the last run.
  for (int i = 0; i < 21; ++i)
    static_cast<void>(downloaded(world, LiveWorld::Download::Scenario));
  ASSERT_EQ(state.maps.size(), 9U);
  EXPECT_EQ(state.maps.front(), "Empty hall");
  EXPECT_EQ(state.maps.back(), "map 19");
  EXPECT_EQ(state.map, 8U);
}

TEST(LiveWorld, ItsChangesReplayToTheBit) {
  LiveWorld world({built_in_maps().back()}, deaf());  // the empty hall
  world.ask(PauseCommand{.paused = true});
  const auto steps = [&](int count) {
    for (int i = 0; i < count; ++i)
      world.ask(StepCommand{});
    static_cast<void>(downloaded(world, LiveWorld::Download::Scenario));
  };
  steps(20);
  world.ask(PaintCommand{.from = {6.0, 2.0}, .to = {8.0, 9.0}, .radius = 0.2, .blocked = true});
  steps(20);
  world.ask(SettingCommand{.assignment = "robot.linear_max=0.6"});
  steps(20);
  world.ask(WalkCommand{.body = {}, .target = {9.0, 10.0}});
  world.ask(WalkCommand{.body = 0, .target = {5.0, 9.0}});
  steps(20);
  world.ask(GoalCommand{.robot = 0, .goal = {.position = {15.0, 3.0}, .heading = 1.0}});
  steps(60);
  world.ask(PaintCommand{.from = {6.0, 2.0}, .to = {8.0, 9.0}, .radius = 0.3, .blocked = false});
  world.ask(RemoveBodyCommand{.body = 0});
  steps(40);
  ReplayCheck check;
  const auto read =
      io::read_recording(downloaded(world, LiveWorld::Download::Recording), "live", check);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_GT(check.cycles(), 100);
  EXPECT_EQ(check.different(), 0);
}

}  // namespace
}  // namespace fairway::app
