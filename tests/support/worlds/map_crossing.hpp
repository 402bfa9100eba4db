// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"
#include "support/random/free_poses.hpp"

namespace fairway::test {

/// Drives a robot between seeded random poses that a path connects: it arrives and touches nothing.
inline void expect_crossings_without_contact(const OccupancyGrid& map) {
  Scenario scenario;
  scenario.map = map;
  scenario.time_limit = 300.0;
  const PreparedMap prepared(scenario.map);
  Planner planner;
  Random random(11);
  int driven = 0;
  for (int attempt = 0; attempt < 60 && driven < 5; ++attempt) {
    const auto start = random_free_pose(random, prepared.obstacles, scenario.settings.robot.radius);
    const auto goal = random_free_pose(random, prepared.obstacles, scenario.settings.robot.radius);
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

}  // namespace fairway::test
