// SPDX-License-Identifier: Apache-2.0
#include "experiments/barn/barn_file.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "support/worlds/small_barn.hpp"

namespace fairway::io {
namespace {

std::string shared(const char* name) { return std::string(FAIRWAY_SHARED_DATA) + "/" + name; }

TEST(BarnFile, ReadsTheSharedWorlds) {
  if (!std::filesystem::exists(shared("barn/barn.json"))) GTEST_SKIP() << "no shared data";
  const auto worlds = read_barn(shared("barn"), {0, 294});
  ASSERT_TRUE(worlds) << worlds.error().message;
  ASSERT_EQ(worlds->size(), 2U);
  const BarnWorld& world = (*worlds)[0];
  EXPECT_EQ(world.number, 0);
  EXPECT_EQ(world.start.position, Eigen::Vector2d(-2.25, 3.0));
  EXPECT_NEAR(world.optimal_time, 6.7961, 1e-9);
  EXPECT_EQ(world.map.frame().width, 208);
}

TEST(BarnFile, ReadsTheSharedMovingWorlds) {
  if (!std::filesystem::exists(shared("dynabarn/dynabarn.json"))) GTEST_SKIP() << "no shared data";
  const auto worlds = read_dynabarn(shared("dynabarn/dynabarn.json"), {});
  ASSERT_TRUE(worlds) << worlds.error().message;
  ASSERT_EQ(worlds->size(), 20U);
  const BarnWorld& world = worlds->front();
  EXPECT_EQ(world.bodies.size(), 11U);
  EXPECT_EQ(world.map.at(world.map.frame().cell_at(world.goal)), CellState::Free);
  EXPECT_TRUE(world.map.frame().contains(world.map.frame().cell_at(world.start.position)));
}

TEST(BarnFile, ReadsTheWorldsOfAFolder) {
  const test::TemporaryFolder folder;
  test::write_small_barn(folder);
  const auto worlds = read_barn(folder.path(""), {});
  ASSERT_TRUE(worlds) << worlds.error().message;
  ASSERT_EQ(worlds->size(), 2U);
  EXPECT_EQ((*worlds)[0].number, 0);
  EXPECT_EQ((*worlds)[1].number, 6);
  const BarnWorld& world = (*worlds)[1];
  EXPECT_EQ(world.start.position, Eigen::Vector2d(-2.25, 3.0));
  EXPECT_EQ(world.start.heading, 1.57);
  EXPECT_EQ(world.goal, Eigen::Vector2d(-2.25, 13.0));
  EXPECT_EQ(world.goal_radius, 1.0);
  EXPECT_EQ(world.timeout, 100.0);
  EXPECT_EQ(world.optimal_time, 5.1);
  EXPECT_EQ(world.map.cells().size(), 120U * 280U);
  EXPECT_EQ(world.map.at(world.map.frame().cell_at({-2.25, 8.1})), CellState::Occupied);
  EXPECT_EQ(world.map.at(world.map.frame().cell_at({-3.0, 8.1})), CellState::Free) << "the door";
}

TEST(BarnFile, ReadsOnlyTheWorldsAskedFor) {
  const test::TemporaryFolder folder;
  test::write_small_barn(folder);
  const auto worlds = read_barn(folder.path(""), {6});
  ASSERT_TRUE(worlds) << worlds.error().message;
  ASSERT_EQ(worlds->size(), 1U);
  EXPECT_EQ(worlds->front().number, 6);
}

TEST(BarnFile, AMovingWorldHasAFloorForAllMotion) {
  const test::TemporaryFolder folder;
  const auto worlds = read_dynabarn(test::write_small_dynabarn(folder), {});
  ASSERT_TRUE(worlds) << worlds.error().message;
  ASSERT_EQ(worlds->size(), 1U);
  const BarnWorld& world = worlds->front();
  EXPECT_EQ(world.number, 3);
  ASSERT_EQ(world.bodies.size(), 1U);
  EXPECT_EQ(world.bodies[0].radius, 0.5);
  EXPECT_EQ(world.bodies[0].key_frames.size(), 3U);
  for (const Eigen::Vector2d& point :
       {world.start.position, world.goal, Eigen::Vector2d(-8, -10), Eigen::Vector2d(2, 7)}) {
    EXPECT_EQ(world.map.at(world.map.frame().cell_at(point)), CellState::Free);
    EXPECT_TRUE(world.map.frame().contains(world.map.frame().cell_at(point)));
  }
}

TEST(BarnFile, AMissingWorldIsNamed) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write(
      "d.json", R"({"start":[0,0,0],"goal":[5,0],"goal_radius":1,"timeout_s":100,"worlds":[]})");
  const auto worlds = read_dynabarn(file, {4});
  ASSERT_FALSE(worlds);
  EXPECT_NE(worlds.error().message.find("a world 4"), std::string::npos);
}

TEST(BarnFile, AnErrorNamesFileAndKey) {
  const test::TemporaryFolder folder;
  const auto message = [&](const std::string& text) {
    const auto worlds = read_dynabarn(folder.write("d.json", text), {});
    return worlds ? std::string("no error") : worlds.error().message;
  };
  const auto names = [&](const std::string& text, const char* key) {
    const std::string found = message(text);
    return found.find("d.json") != std::string::npos && found.find(key) != std::string::npos;
  };
  EXPECT_TRUE(names("not json", "JSON"));
  EXPECT_TRUE(names("[]", "start"));
  EXPECT_TRUE(names(R"({"start":[0,0],"goal":[5,0],"goal_radius":1,"timeout_s":9,"worlds":[]})",
                    "start: expected 3 numbers"));
  EXPECT_TRUE(names(R"({"start":[0,0,0],"goal":[5,0],"goal_radius":-1,"timeout_s":9,"worlds":[]})",
                    "goal_radius"));
  EXPECT_TRUE(names(R"({"start":[0,0,0],"goal":[5,0],"goal_radius":1,"timeout_s":9,"worlds":[]})",
                    "at least one"));
  EXPECT_TRUE(
      names(R"({"start":[0,0,0],"goal":[5,0],"goal_radius":1,"timeout_s":9,"worlds":[{"world":1,
        "obstacles":[{"name":"a","radius":0.5,"keys":[[1,0,0],[1,2,2]]}]}]})",
            "increasing times"));
  EXPECT_TRUE(names(
      R"({"start":[0,0,0],"goal":[5,0],"goal_radius":1,"timeout_s":9,"worlds":[{"obstacles":[]}]})",
      "world: expected a number"));
  EXPECT_FALSE(read_barn(folder.path("nothing"), {}));
}

}  // namespace
}  // namespace fairway::io
