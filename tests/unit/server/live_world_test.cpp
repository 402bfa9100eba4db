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

std::string default_of(const std::string& setting) {
  std::string text;
  const Settings settings;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& info) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) {
        if (std::string(group) + '.' + info.name == setting) text = std::to_string(value);
      }
    });
  });
  return text;
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

// A setting that is allowed alone must not end anything, whatever the others are.
TEST(LiveWorld, GoesOnWithEverySettingAtTheEndOfItsRange) {
  std::vector<std::string> ends;
  const Settings settings;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& info) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) {
        for (const double end : {info.min, info.max})
          ends.push_back(std::string(group) + '.' + info.name + '=' + std::to_string(end));
      }
    });
  });
  LiveWorld world({built_in_maps().back()}, deaf());
  world.ask(PauseCommand{.paused = true});
  world.ask(SenseCommand{.sensing = Sensing::Lidar, .noise = SensorNoise::None});
  for (const std::string& end : ends) {
    world.ask(SettingCommand{.assignments = {end}});
    world.ask(StepCommand{});
    static_cast<void>(downloaded(world, LiveWorld::Download::Scenario));
    const std::string name = end.substr(0, end.find('='));
    world.ask(SettingCommand{.assignments = {name + "=" + default_of(name)}});
  }
  EXPECT_FALSE(downloaded(world, LiveWorld::Download::Scenario).empty());
}

TEST(LiveWorld, ClampsAStrokeToTheMap) {
  LiveWorld world({built_in_maps().back()}, deaf());
  world.ask(PauseCommand{.paused = true});
  const OccupancyGrid fine(
      GridFrame{.width = 60, .height = 60, .resolution = 0.0001, .origin = {}});
  ASSERT_TRUE(world.use_map(scenario_on("fine", fine)));
  for (const double far : {-1e6, 1e6})
    world.ask(PaintCommand{.from = {far, far}, .to = {far, far}, .radius = 5.0, .blocked = true});
  world.ask(PaintCommand{.from = {-50, 0}, .to = {50, 0}, .radius = 1e-9, .blocked = true});
  EXPECT_FALSE(downloaded(world, LiveWorld::Download::Scenario).empty());
}

// A world that cannot keep up with its speed serves what it is asked for all the same.
TEST(LiveWorld, ServesRequestsHoweverLateItIs) {
  std::atomic<bool> paused = false;
  LiveListener listener = deaf();
  listener.on_state = [&](const LiveState& state) { paused = state.paused; };
  LiveWorld world(built_in_maps(), listener);
  world.ask(SenseCommand{.sensing = Sensing::Lidar, .noise = SensorNoise::Standard});
  for (int i = 0; i < 8; ++i)
    world.ask(AddRobotCommand{.pose = {.position = {2.0 + i, 2.0}, .heading = 0.0}});
  world.ask(SpeedCommand{.factor = 100.0});
  for (int i = 0; i < 5; ++i)
    static_cast<void>(downloaded(world, LiveWorld::Download::Scenario));
  world.ask(PauseCommand{.paused = true});
  static_cast<void>(downloaded(world, LiveWorld::Download::Scenario));
  EXPECT_TRUE(paused);
}

TEST(LiveWorld, KeepsTheNewestUploads) {
  LiveState state;  // the last state; read after the world has answered
  LiveListener listener = deaf();
  listener.on_state = [&](const LiveState& now) { state = now; };
  LiveWorld world({built_in_maps().back()}, listener);
  const OccupancyGrid map(GridFrame{.width = 100, .height = 100, .resolution = 0.05, .origin = {}});
  for (int i = 0; i < 20; ++i)
    while (!world.use_map(scenario_on("map " + std::to_string(i), map)))
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
  world.ask(SettingCommand{.assignments = {"robot.linear_max=0.6"}});
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
