// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/scenario/scenario_file.hpp"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "small_map.hpp"
#include "support/runs/temporary_folder.hpp"

namespace fairway::io {
namespace {

using test::TemporaryFolder;
using test::write_map;

TEST(ScenarioFile, ReadsEveryKey) {
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

TEST(ScenarioFile, ReadsSensingAndPhysics) {
  const TemporaryFolder folder;
  write_map(folder);
  const std::string rest = "map: m.yaml\nrobots: [{start: [1, 1, 0], goal: [8, 4]}]\n";
  const auto plain = read_scenario(folder.write("plain.yaml", rest));
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_EQ(plain->sensing.sensing, Sensing::Map);
  EXPECT_EQ(plain->sensing.pose, PoseSource::Exact);
  EXPECT_EQ(plain->engine, Engine::Unicycle);
  const auto real = read_scenario(
      folder.write("real.yaml", rest + "sensing: lidar\nnoise: standard\nphysics: mujoco\n"));
  ASSERT_TRUE(real) << real.error().message;
  EXPECT_EQ(real->sensing.sensing, Sensing::Lidar);
  EXPECT_EQ(real->sensing.lidar.latency, 0.05);
  EXPECT_EQ(real->engine, Engine::Mujoco);
  const auto located = read_scenario(folder.write("located.yaml", rest + "pose: scans\n"));
  ASSERT_TRUE(located) << located.error().message;
  EXPECT_EQ(located->sensing.pose, PoseSource::Scans);
  const auto both =
      read_scenario(folder.write("both.yaml", rest + "sensing: lidar\npose: scans\n"));
  ASSERT_FALSE(both);
  EXPECT_NE(both.error().message.find(":4: pose: expected exact with sensing: lidar, found scans"),
            std::string::npos)
      << both.error().message;
  const auto wrong = read_scenario(folder.write("wrong.yaml", rest + "physics: magic\n"));
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find(":3: physics: expected unicycle or mujoco"),
            std::string::npos)
      << wrong.error().message;
}

TEST(ScenarioFile, LetsPeopleWalk) {
  const TemporaryFolder folder;
  write_map(folder);
  const std::string head = "map: m.yaml\nrobots: [{start: [1, 1, 0], goal: [8, 4]}]\n";
  const auto scenario = read_scenario(folder.write(
      "s.yaml", head + "time_limit: 10\npeople:\n  kind: social_force\n  walkers:\n"
                       "    - {name: ann, start: [0, 4], goal: [8, 4], speed: 1, radius: 0.25}\n"
                       "    - {start: [8, 1], goal: [0, 1]}\n"));
  ASSERT_TRUE(scenario) << scenario.error().message;
  ASSERT_EQ(scenario->bodies.size(), 2U);
  EXPECT_EQ(scenario->bodies[0].name, "ann");
  EXPECT_EQ(scenario->bodies[0].radius, 0.25);
  EXPECT_EQ(scenario->bodies[1].name, "person 2");
  EXPECT_GT(scenario->bodies[0].at(10.0).position.x(), 6.0);
  const auto seeing = read_scenario(folder.write(
      "r.yaml", head + "people:\n  sees_robots: true\n  walkers:\n"
                       "    - {start: [0, 4], goal: [8, 4], group: pair, returns: true}\n"));
  ASSERT_TRUE(seeing) << seeing.error().message;
  ASSERT_TRUE(seeing->bodies.at(0).walk);
  EXPECT_EQ(seeing->bodies[0].walk->group, "pair");
  EXPECT_TRUE(seeing->bodies[0].walk->returns);
  EXPECT_EQ(seeing->bodies[0].key_frames.size(), 1U) << "walks as the run proceeds";
  const auto refused = [&](const std::string& people, const std::string& expected) {
    const auto wrong = read_scenario(folder.write("wrong.yaml", head + people));
    ASSERT_FALSE(wrong) << people;
    EXPECT_NE(wrong.error().message.find(expected), std::string::npos) << wrong.error().message;
  };
  refused("people: {kind: crowd, walkers: [{start: [0, 4], goal: [8, 4]}]}\n", "kind: expected");
  refused("people: {walkers: []}\n", "walkers: expected 1 to 200 people");
  refused("people: {walkers: [{start: [0, 4]}]}\n", "goal: expected");
}

TEST(ScenarioFile, DescribesTheActualBases) {
  const TemporaryFolder folder;
  write_map(folder);
  const std::string head = "map: m.yaml\nsettings: {robot: {linear_lag: 0.05}}\nrobots:\n";
  const auto scenario = read_scenario(folder.write(
      "s.yaml",
      head + "  - {start: [1, 1, 0], goal: [8, 4]}\n"
             "  - start: [2, 2, 0]\n    goal: [8, 4]\n"
             "    actuation: {delay: {linear: 0.3, lateral: 0.2, angular: 0.1},\n"
             "      lag: {linear: 0.2}, acceleration: {linear: 1}, braking: {angular: 3}}\n"));
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_FALSE(scenario->robots[0].actuation);
  ASSERT_TRUE(scenario->robots[1].actuation);
  const UnicycleLimits& base = *scenario->robots[1].actuation;
  EXPECT_EQ(base.linear_delay, 0.3);
  EXPECT_EQ(base.angular_delay, 0.1);
  EXPECT_EQ(base.linear_lag, 0.2);
  EXPECT_EQ(base.linear_acceleration, 1.0);
  EXPECT_EQ(base.angular_acceleration, 4.0) << "as the settings say";
  EXPECT_EQ(base.linear_braking, 0.0) << "as it accelerates";
  EXPECT_EQ(base.angular_braking, 3.0);
  // Settings that were not changed are those of the base; others stay.
  EXPECT_EQ(scenario->settings.robot.linear_delay, 0.3);
  EXPECT_EQ(scenario->settings.robot.linear_acceleration_max, 1.0);
  EXPECT_EQ(scenario->settings.robot.linear_lag, 0.05);
  const auto wrong = read_scenario(folder.write(
      "w.yaml",
      head + "  - {start: [1, 1, 0], goal: [8, 4], actuation: {delay: {linear: 0.7}}}\n"));
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find("delay.linear: expected a number from 0 to 0.6"),
            std::string::npos)
      << wrong.error().message;
}

TEST(ScenarioFile, ReadsTheRadio) {
  const TemporaryFolder folder;
  write_map(folder);
  const std::string rest = "map: m.yaml\nrobots: [{start: [1, 1, 0], goal: [8, 4]}]\n";
  const auto some =
      read_scenario(folder.write("s.yaml", rest + "radio: {delay: 0.2, loss: 0.25}\n"));
  ASSERT_TRUE(some) << some.error().message;
  EXPECT_TRUE(some->radio.on);
  EXPECT_EQ(some->radio.delay, 0.2);
  EXPECT_EQ(some->radio.loss, 0.25);
  const auto none = read_scenario(folder.write("n.yaml", rest + "radio: {on: false}\n"));
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_FALSE(none->radio.on);
  const std::string path = folder.write("w.yaml", rest + "radio: {loss: 2}\n");
  const auto wrong = read_scenario(path);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().message.find(path + ":3: radio.loss: expected "), 0U)
      << wrong.error().message;
}

TEST(ScenarioFile, ReplaysPedestriansFromATimeOfTheRecording) {
  const TemporaryFolder folder;
  write_map(folder);
  folder.write("tracks.txt",
               "0 7 1.0 0 1.0 0 0 0\n10 7 2.0 0 1.0 0 0 0\n\n"
               "100 3 5e0 0 1 0 0 0\n110 3 5 0 2.0 0 0 0\n");
  const std::string rest =
      "map: m.yaml\ntime_limit: 20\nrobots: [{start: [1, 1, 0], goal: [2, 2]}]\n";
  const auto all = read_scenario(
      folder.write("all.yaml", rest + "pedestrians: {tracks: tracks.txt, frame_rate: 10}\n"));
  ASSERT_TRUE(all) << all.error().message;
  ASSERT_EQ(all->bodies.size(), 2U);
  EXPECT_EQ(all->bodies[0].name, "person 3");
  EXPECT_TRUE(all->bodies[0].passing);
  EXPECT_EQ(all->bodies[0].key_frames[1].time, 11.0);
  const auto later = read_scenario(folder.write(
      "later.yaml",
      rest + "pedestrians: {tracks: tracks.txt, frame_rate: 10, from: 10.5, radius: 0.25}\n"));
  ASSERT_TRUE(later) << later.error().message;
  ASSERT_EQ(later->bodies.size(), 1U);
  EXPECT_EQ(later->bodies[0].at(0.0).position, Eigen::Vector2d(5, 1.5));
  EXPECT_EQ(later->bodies[0].radius, 0.25);
}

TEST(ScenarioFile, ReportsErrorsInTracks) {
  const TemporaryFolder folder;
  write_map(folder);
  const std::string path = folder.write(
      "s.yaml",
      "map: m.yaml\nrobots: [{start: [1, 1, 0], goal: [2, 2]}]\npedestrians:\n  tracks: t.txt\n");
  const auto message = [&](const std::string& tracks) {
    const std::string file = folder.write("t.txt", tracks);
    const auto scenario = read_scenario(path);
    if (scenario) return std::string("no error");
    const std::string before = path + ":4: pedestrians.tracks: " + file;
    const std::string& text = scenario.error().message;
    return text.substr(0, before.size()) == before ? text.substr(before.size()) : text;
  };
  EXPECT_EQ(message(""), ":1: expected tracks of people, found none");
  EXPECT_EQ(message("1 2 3 4 5 6 7 8\n1 2 x 4 5 6 7 8\n"), ":2: x: expected a number, found 'x'");
  EXPECT_EQ(message("1 2 3\n"), ":1: z: expected a number, found the end of the line");
  EXPECT_EQ(message("1 2 3 4 5 6 7 8 9\n"), ":1: expected 8 numbers, found more: '9'");
  EXPECT_EQ(message("1 2.5 3 4 5 6 7 8\n"),
            ":1: id: expected a whole number from 0 to 1e+09, found 2.5");
  EXPECT_EQ(message("1 2 3 4 nan 6 7 8\n"), ":1: y: expected a number, found 'nan'");
  EXPECT_EQ(message("5 2 3 4 5 6 7 8\n5 2 3 4 5 6 7 8\n"),
            ":2: frame: expected one after 5 of person 2, found 5");
  std::filesystem::remove(std::filesystem::path(path).parent_path() / "t.txt");
  const auto absent = read_scenario(path);
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().message.find(path + ":4: pedestrians.tracks: "), 0U)
      << absent.error().message;
}

TEST(ScenarioFile, UsesDefaultsForMissingKeys) {
  const TemporaryFolder folder;
  write_map(folder);
  const auto scenario = read_scenario(
      folder.write("s.yaml", "map: m.yaml\nrobots: [{start: [1, 1, 0], goal: [2, 2]}]\n"));
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->name, "s");
  EXPECT_EQ(scenario->time_limit, Scenario{}.time_limit);
  EXPECT_EQ(scenario->robots[0].name, "robot 1");
}

TEST(ScenarioFile, ItsErrorsAreOneLineForAnyContent) {
  const TemporaryFolder folder;
  const auto scenario = read_scenario(folder.write("s.yaml", "map: \"a\\nb.yaml\"\nrobots: []\n"));
  ASSERT_FALSE(scenario);
  EXPECT_EQ(scenario.error().message.find('\n'), std::string::npos) << scenario.error().message;
}

TEST(ScenarioFile, RefusesTwoRobotsOfOneName) {
  const TemporaryFolder folder;
  write_map(folder);
  const std::string path =
      folder.write("s.yaml",
                   "map: m.yaml\nrobots:\n  - {name: a, start: [1, 1, 0], goal: [2, 2]}\n"
                   "  - {name: a, start: [3, 1, 0], goal: [2, 2]}\n");
  EXPECT_EQ(read_scenario(path).error().message,
            path + ":4: robots[1].name: expected a unique name, found 'a' again");
}

TEST(ScenarioFile, ReadsOurOwnScenarios) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FAIRWAY_SOURCE_DIR "/scenarios")) {
    if (entry.path().extension() != ".yaml") continue;
    const auto scenario = read_scenario(entry.path().string());
    // Its tracks are not part of the project.
    if (entry.path().stem() == "pedestrians" && !scenario) {
      EXPECT_NE(scenario.error().message.find("pedestrians.tracks: "), std::string::npos);
      continue;
    }
    EXPECT_TRUE(scenario) << scenario.error().message;
    ++count;
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace fairway::io
