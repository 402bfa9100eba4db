// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/exact/scenario_archive.hpp"

#include <gtest/gtest.h>

#include "fairway/io/scenario/scenario_file.hpp"
#include "fairway/io/whole_file.hpp"
#include "fairway/io/yaml/settings_file.hpp"
#include "support/random/random_world.hpp"
#include "support/runs/temporary_folder.hpp"

namespace fairway::io {
namespace {

TEST(ScenarioArchive, ReadsBackAsTheSameScenario) {
  test::Random random(11);
  Scenario scenario;
  scenario.name = "a \"name\": with # marks";
  scenario.map = test::random_world(random, 60);
  scenario.map.set({.x = 3, .y = 5}, CellState::Unknown);
  scenario.settings.robot.linear_max = 1.0 / 3.0;
  scenario.time_limit = 12.5;
  scenario.seed = 77;
  scenario.sensing.sensing = Sensing::Lidar;
  use_standard_noise(scenario.sensing);
  scenario.engine = Engine::Mujoco;
  ASSERT_TRUE(scenario.settings.robot.discs.add({0.1, 1.0 / 7.0}, 0.2));
  const GridFrame& frame = scenario.map.frame();
  scenario.robots = {{.name = "one",
                      .start = {.position = frame.center({.x = 2, .y = 2}), .heading = 0.1},
                      .goal = {.position = frame.center({.x = 9, .y = 2}), .heading = -1.5}},
                     {.name = "two",
                      .start = {.position = frame.center({.x = 5, .y = 5}), .heading = 3.0},
                      .goal = {.position = frame.center({.x = 2, .y = 9}), .heading = {}}}};
  scenario.bodies = {{.name = "person",
                      .radius = 0.35,
                      .key_frames = {{.time = 0.0, .position = {0.1, 0.2}},
                                     {.time = 2.5, .position = {1e-3, -4.0}}},
                      .loop = true},
                     {.name = "walker",
                      .key_frames = {{.time = 0.0, .position = {0.5, 0.5}}},
                      .walk = WalkPlan{.model = WalkingModel::SocialForce,
                                       .from = {0.5, 0.5},
                                       .to = {1.0 / 3.0, 2.0},
                                       .speed = 0.7,
                                       .returns = true,
                                       .group = "a \"pair\""}}};

  const test::TemporaryFolder folder;
  for (const ArchiveFile& file : scenario_files(scenario))
    ASSERT_TRUE(write_file_atomically(folder.path(file.name), file.content));
  const Expected<Scenario> read = read_scenario(folder.path("scenario.yaml"));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->name, scenario.name);
  EXPECT_EQ(read->time_limit, scenario.time_limit);
  EXPECT_EQ(read->seed, scenario.seed);
  EXPECT_EQ(read->sensing.sensing, Sensing::Lidar);
  EXPECT_EQ(read->sensing.lidar.latency, scenario.sensing.lidar.latency);
  EXPECT_EQ(read->engine, Engine::Mujoco);
  EXPECT_EQ(settings_yaml(read->settings), settings_yaml(scenario.settings));
  EXPECT_TRUE(std::ranges::equal(read->map.cells(), scenario.map.cells()));
  EXPECT_EQ(read->map.frame().origin.heading, frame.origin.heading);
  ASSERT_EQ(read->robots.size(), 2U);
  EXPECT_EQ(read->robots[0].goal.heading, -1.5);
  EXPECT_FALSE(read->robots[1].goal.heading);
  EXPECT_EQ(read->robots[1].start.position, scenario.robots[1].start.position);
  ASSERT_EQ(read->bodies.size(), 2U);
  EXPECT_FALSE(read->bodies[0].walk);
  ASSERT_TRUE(read->bodies[1].walk);
  EXPECT_EQ(read->bodies[1].walk->model, WalkingModel::SocialForce);
  EXPECT_EQ(read->bodies[1].walk->from, scenario.bodies[1].walk->from);
  EXPECT_EQ(read->bodies[1].walk->to, scenario.bodies[1].walk->to);
  EXPECT_EQ(read->bodies[1].walk->speed, 0.7);
  EXPECT_TRUE(read->bodies[1].walk->returns);
  EXPECT_EQ(read->bodies[1].walk->group, "a \"pair\"");
  EXPECT_TRUE(read->bodies[0].loop);
  EXPECT_EQ(read->bodies[0].key_frames[1].position, scenario.bodies[0].key_frames[1].position);
}

TEST(ZipArchive, IsUnpackedByPython) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("a.zip");
  const std::string bytes = zip_archive({{.name = "one.txt", .content = "first"},
                                         {.name = "two.bin", .content = std::string(3, '\0')}});
  ASSERT_TRUE(write_file_atomically(path, bytes));
  const std::string script =
      "import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; "
      "assert z.namelist() == ['one.txt', 'two.bin']; assert z.read('one.txt') == b'first'";
  EXPECT_EQ(std::system(("python3 -c \"" + script + "\" " + path).c_str()), 0);
}

}  // namespace
}  // namespace fairway::io
