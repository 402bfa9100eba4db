// SPDX-License-Identifier: Apache-2.0
// Whole runs on maps of real buildings, between seeded random points that are connected.
#include <filesystem>

#include <gtest/gtest.h>

#include "fairway/io/maps/map_file.hpp"
#include "fairway/simulation/episode.hpp"
#include "support/free_poses.hpp"

namespace fairway {
namespace {

class RealMaps : public testing::TestWithParam<const char*> {};

TEST_P(RealMaps, AreCrossedWithoutContact) {
  const std::filesystem::path maps = std::filesystem::path(FAIRWAY_SHARED_DATA) / "maps";
  const std::string file = (maps / GetParam()).string() + ".yaml";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no shared data: " << file;
  const Expected<OccupancyGrid> map = io::read_map(file);
  ASSERT_TRUE(map) << map.error().message;

  Scenario scenario;
  scenario.map = *map;
  scenario.time_limit = 300.0;
  const PreparedMap prepared(scenario.map);
  Planner planner;
  test::Random random(11);
  int driven = 0;
  for (int attempt = 0; attempt < 60 && driven < 5; ++attempt) {
    const auto start =
        test::random_free_pose(random, prepared.obstacles, scenario.settings.robot.radius);
    const auto goal =
        test::random_free_pose(random, prepared.obstacles, scenario.settings.robot.radius);
    ASSERT_TRUE(start && goal);
    const Goal to{.position = goal->position, .heading = goal->heading};
    const Plan plan =
        planner.plan(prepared, start->position, to, planner_settings(scenario.settings));
    if (plan.path_status != PathStatus::Found || plan.path.length() < 3.0) continue;
    SCOPED_TRACE(testing::Message()
                 << "from " << start->position.transpose() << " to " << goal->position.transpose());
    EXPECT_TRUE(plan.usable()) << plan.reason();
    scenario.robots = {{.name = "robot", .start = *start, .goal = to}};
    const EpisodeResult result = run_episode(scenario);
    EXPECT_TRUE(result.robots[0].reached) << to_text(result.trace.rows.back().status);
    EXPECT_FALSE(result.robots[0].collided);
    ++driven;
  }
  EXPECT_GE(driven, 4);
}

INSTANTIATE_TEST_SUITE_P(Shared,
                         RealMaps,
                         testing::Values("depot", "tb3_world", "willow-full-0.05"),
                         [](const auto& map) {
                           std::string name = map.param;
                           std::erase_if(name, [](char c) { return std::isalnum(c) == 0; });
                           return name;
                         });

}  // namespace
}  // namespace fairway
