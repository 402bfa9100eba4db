// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/scenario_file.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "fairway/io/trace_file.hpp"
#include "support/temporary_folder.hpp"

namespace fairway::io {
namespace {

using test::TemporaryFolder;

// Writes a free map of 10 m by 5 m.
void write_map(const TemporaryFolder& folder) {
  folder.write("m.pgm", "P5 10 5 255\n" + std::string(50, '\xff'));
  folder.write("m.yaml",
               "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
               "free_thresh: 0.196\n");
}

TEST(ScenarioFile, HoldsEverything) {
  const TemporaryFolder folder;
  write_map(folder);
  const auto scenario = read_scenario(folder.write(
      "s.yaml",
      "map: m.yaml\nname: hall\ntime_limit: 33\nseed: 7\n"
      "settings: {preset: paper, robot: {radius: 0.4}}\n"
      "robots:\n  - {name: a, start: [1, 2, 3], goal: [8, 4]}\n"
      "  - {start: [2, 2, 0], goal: [1, 1, -1.5]}\n"
      "obstacles:\n  - {name: p, radius: 0.5, loop: true, key_frames: [[0, 1, 1], [2.5, 3, 4]]}\n"
      "  - {key_frames: [[0, 5, 5]]}\n"));
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->name, "hall");
  EXPECT_EQ(scenario->map.frame().width, 10);
  EXPECT_EQ(scenario->time_limit, 33.0);
  EXPECT_EQ(scenario->seed, 7U);
  EXPECT_EQ(scenario->settings.robot.radius, 0.4);
  EXPECT_EQ(scenario->settings.mpc.horizon, paper_settings().mpc.horizon);
  ASSERT_EQ(scenario->robots.size(), 2U);
  EXPECT_EQ(scenario->robots[0].name, "a");
  EXPECT_EQ(scenario->robots[0].start.position, Eigen::Vector2d(1, 2));
  EXPECT_EQ(scenario->robots[0].start.heading, 3.0);
  EXPECT_EQ(scenario->robots[0].goal.position, Eigen::Vector2d(8, 4));
  EXPECT_FALSE(scenario->robots[0].goal.heading);
  EXPECT_EQ(scenario->robots[1].name, "robot 2");
  EXPECT_EQ(scenario->robots[1].goal.heading, -1.5);
  ASSERT_EQ(scenario->bodies.size(), 2U);
  EXPECT_EQ(scenario->bodies[0].radius, 0.5);
  EXPECT_TRUE(scenario->bodies[0].loop);
  ASSERT_EQ(scenario->bodies[0].key_frames.size(), 2U);
  EXPECT_EQ(scenario->bodies[0].key_frames[1].time, 2.5);
  EXPECT_EQ(scenario->bodies[0].key_frames[1].position, Eigen::Vector2d(3, 4));
  EXPECT_FALSE(scenario->bodies[1].loop);
}

TEST(ScenarioFile, SaysHowRobotsSenseAndWhatMovesThem) {
  const TemporaryFolder folder;
  write_map(folder);
  const std::string rest = "map: m.yaml\nrobots: [{start: [1, 1, 0], goal: [8, 4]}]\n";
  const auto plain = read_scenario(folder.write("plain.yaml", rest));
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_EQ(plain->sensing.sensing, Sensing::Map);
  EXPECT_EQ(plain->engine, Engine::Unicycle);
  const auto real = read_scenario(
      folder.write("real.yaml", rest + "sensing: lidar\nnoise: standard\nphysics: mujoco\n"));
  ASSERT_TRUE(real) << real.error().message;
  EXPECT_EQ(real->sensing.sensing, Sensing::Lidar);
  EXPECT_EQ(real->sensing.lidar.latency, 0.05);
  EXPECT_EQ(real->engine, Engine::Mujoco);
  const auto wrong = read_scenario(folder.write("wrong.yaml", rest + "physics: magic\n"));
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find(":3: physics: expected unicycle or mujoco"),
            std::string::npos)
      << wrong.error().message;
}

TEST(ScenarioFile, TakesDefaultsForWhatItLeavesOut) {
  const TemporaryFolder folder;
  write_map(folder);
  const auto scenario = read_scenario(
      folder.write("s.yaml", "map: m.yaml\nrobots: [{start: [1, 1, 0], goal: [2, 2]}]\n"));
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->name, "s");
  EXPECT_EQ(scenario->time_limit, Scenario{}.time_limit);
  EXPECT_EQ(scenario->robots[0].name, "robot 1");
}

TEST(ScenarioFile, RefusesTwoRobotsOfOneName) {
  const TemporaryFolder folder;
  write_map(folder);
  const std::string path =
      folder.write("s.yaml",
                   "map: m.yaml\nrobots:\n  - {name: a, start: [1, 1, 0], goal: [2, 2]}\n"
                   "  - {name: a, start: [3, 1, 0], goal: [2, 2]}\n");
  EXPECT_EQ(read_scenario(path).error().message,
            path + ":4: robots[1].name: expected a name of its own, found 'a' again");
}

TEST(ScenarioFile, ReadsOurOwnScenarios) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FAIRWAY_SOURCE_DIR "/scenarios")) {
    if (entry.path().extension() != ".yaml") continue;
    const auto scenario = read_scenario(entry.path().string());
    EXPECT_TRUE(scenario) << scenario.error().message;
    ++count;
  }
  EXPECT_GT(count, 0);
}

TEST(TraceFile, HasARowPerRobotAndCycle) {
  EpisodeResult episode;
  episode.robots = {{.name = "a"}, {.name = "b, \"c\""}};
  episode.trace.rows = {{.time = 0.5,
                         .robot = 0,
                         .pose = {.position = {1, -2}, .heading = 0.25},
                         .twist = {.linear = 0.5, .angular = -0.5},
                         .command = {.linear = 0.75, .angular = 0.125},
                         .status = NavigationStatus::Ok,
                         .limit = Limit::Speed,
                         .rectangle = 3,
                         .clearance = 1.5},
                        {.time = 0.5, .robot = 1}};
  EXPECT_EQ(trace_csv(episode),
            "time,robot,x,y,heading,linear,angular,status,command_linear,command_angular,limit,"
            "rectangle,clearance\n"
            "0.5,a,1,-2,0.25,0.5,-0.5,ok,0.75,0.125,speed limit,3,1.5\n"
            "0.5,\"b, \"\"c\"\"\",0,0,0,0,0,no plan,0,0,none,0,0\n");
}

}  // namespace
}  // namespace fairway::io
