// SPDX-License-Identifier: Apache-2.0
// What holds for plans in random worlds.
#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "fairway/planning/planner.hpp"
#include "support/oracles/corridor_promises.hpp"
#include "support/oracles/path_oracle.hpp"
#include "support/random/free_poses.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kDisc = 0.15;  // radius of the robot [m]

PlannerSettings for_the_disc() {
  PlannerSettings settings;
  settings.radius = kDisc;
  return settings;
}

// One planner in many worlds, from a free place to another one.
class PlannerLaws : public testing::Test {
 protected:
  struct Task {
    PreparedMap map;
    Vector2d start;
    Vector2d goal;
  };

  std::optional<Task> next_task() {
    const BitGrid obstacles(test::random_world(random_, 90));
    const auto start = test::random_free_pose(random_, obstacles, kDisc + 1e-4);
    const auto goal = test::random_free_pose(random_, obstacles, kDisc + 1e-4);
    if (!start || !goal) return std::nullopt;
    return Task{.map = PreparedMap(obstacles), .start = start->position, .goal = goal->position};
  }

  // Calls `check(task, plan)` for the plans that could be made; at least `enough` of them.
  template <typename Check>
  void for_plans(int worlds, int enough, Check&& check) {
    int usable = 0;
    for (int i = 0; i < worlds; ++i) {
      const std::optional<Task> task = next_task();
      if (!task) continue;
      const Plan plan =
          planner_.plan(task->map, task->start, {.position = task->goal}, for_the_disc());
      if (!plan.usable()) continue;
      ++usable;
      check(*task, plan);
    }
    EXPECT_GE(usable, enough);
  }

  test::Random random_{7};
  Planner planner_;
};

TEST_F(PlannerLaws, APathLeadsFromStartToGoalAndIsFreeForTheRobot) {
  for_plans(150, 50, [](const Task& task, const Plan& plan) {
    EXPECT_EQ(plan.path.waypoints.front(), task.start);
    EXPECT_EQ(plan.path.waypoints.back(), task.goal);
    for (std::size_t i = 1; i < plan.path.waypoints.size(); ++i) {
      EXPECT_TRUE(
          is_free(task.map.obstacles, plan.path.waypoints[i - 1], plan.path.waypoints[i], kDisc));
    }
  });
}

TEST_F(PlannerLaws, ACorridorKeepsItsPromisesAlongThePath) {
  for_plans(100, 30, [](const Task& task, const Plan& plan) {
    CorridorSettings least = for_the_disc().corridor;
    least.min_overlap_area *= 0.05;  // the last attempt
    test::expect_a_sound_chain(task.map.obstacles, plan.path, plan.corridor, least, false);
    EXPECT_TRUE(fits(plan, kDisc, kDisc));
  });
}

// A cell-by-cell search at the least margin that the planner tries finds no more than the planner.
TEST_F(PlannerLaws, APlanExistsWhereNeighbouringCellsConnectWithTheLeastMargin) {
  int connected = 0;
  for (int i = 0; i < 60; ++i) {
    const std::optional<Task> task = next_task();
    if (!task) continue;
    const BitGrid& obstacles = task->map.obstacles;
    const GridFrame& frame = obstacles.frame();
    const double required = kDisc + 0.05 * for_the_disc().path.margin;
    const CellIndex from = frame.cell_at(task->start);
    const CellIndex to = frame.cell_at(task->goal);
    if (!is_free(obstacles, task->start, frame.center(from), required) ||
        !is_free(obstacles, task->goal, frame.center(to), required) ||
        !test::is_connected(obstacles, required, from, to)) {
      continue;
    }
    ++connected;
    const Plan plan =
        planner_.plan(task->map, task->start, {.position = task->goal}, for_the_disc());
    EXPECT_EQ(plan.path_status, PathStatus::Found) << "world " << i;
  }
  EXPECT_GT(connected, 15);
}

// Two rooms, and a door of this many cells of 1 cm between them.
PreparedMap door_of(int cells) {
  BitGrid map({.width = 300, .height = 200, .resolution = 0.01, .origin = {}}, false);
  for (int y = 0; y < 200; ++y) {
    if (y < 90 || y >= 90 + cells) map.set({150, y}, true);
  }
  return PreparedMap(map);
}

// The margin is reduced only where a greater one has no plan.
TEST(Planner, AReducedMarginIsNecessary) {
  const double desired = for_the_disc().path.margin;
  int reduced = 0;
  for (int cells = 30; cells <= 46; ++cells) {
    const PreparedMap map = door_of(cells);
    const Goal goal{.position = {2.5, 1.0}, .heading = {}};
    const Plan plan = Planner().plan(map, {0.5, 1.0}, goal, for_the_disc());
    if (!plan.usable()) continue;
    EXPECT_LT(2.0 * (kDisc + plan.margin), 0.01 * cells) << "it fits through the door";
    if (plan.margin == desired) continue;
    ++reduced;
    PlannerSettings wider = for_the_disc();
    for (const double share : {1.0, 0.5, 0.2}) {
      wider.path.margin = desired * share;
      if (wider.path.margin <= plan.margin * 1.01) break;
      EXPECT_FALSE(
          Planner()
              .plan(map, {0.5, 1.0}, goal, wider, {.clock = {}, .build = {}, .fixed_margin = true})
              .usable())
          << wider.path.margin << " was possible, " << plan.margin << " was used";
    }
  }
  EXPECT_GT(reduced, 2);
}

TEST(Planner, AMarginOfWhichAPartFitsDoesNotCloseADoor) {
  EXPECT_TRUE(
      Planner().plan(door_of(33), {0.5, 1.0}, {.position = {2.5, 1.0}}, for_the_disc()).usable());
  EXPECT_FALSE(
      Planner().plan(door_of(29), {0.5, 1.0}, {.position = {2.5, 1.0}}, for_the_disc()).usable())
      << "narrower than the robot";
}

TEST_F(PlannerLaws, AFixedMarginIsKeptOrThereIsNoPlan) {
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    const std::optional<Task> task = next_task();
    if (!task) continue;
    PlannerSettings settings = for_the_disc();
    settings.path.margin = 0.1;
    const Plan plan = planner_.plan(task->map, task->start, {.position = task->goal}, settings,
                                    {.clock = {}, .build = {}, .fixed_margin = true});
    if (!plan.usable()) continue;
    ++found;
    EXPECT_EQ(plan.margin, 0.1);
  }
  EXPECT_GT(found, 20);
}

// A planner keeps its memory, and nothing of what it planned before.
TEST_F(PlannerLaws, APlanDoesNotDependOnThePlansBefore) {
  for_plans(60, 15, [](const Task& task, const Plan& plan) {
    Planner fresh;
    const Plan again = fresh.plan(task.map, task.start, {.position = task.goal}, for_the_disc());
    ASSERT_EQ(again.path.waypoints.size(), plan.path.waypoints.size());
    for (std::size_t i = 0; i < plan.path.waypoints.size(); ++i)
      EXPECT_EQ(again.path.waypoints[i], plan.path.waypoints[i]);
    ASSERT_EQ(again.corridor.rectangles.size(), plan.corridor.rectangles.size());
    for (std::size_t i = 0; i < plan.corridor.rectangles.size(); ++i) {
      EXPECT_EQ(again.corridor.rectangles[i].min, plan.corridor.rectangles[i].min);
      EXPECT_EQ(again.corridor.rectangles[i].max, plan.corridor.rectangles[i].max);
    }
  });
}

// A plan that pauses after every search has the same bits as one made at once.
TEST_F(PlannerLaws, APausedPlanContinuesToTheSameResult) {
  PlannerSettings settings = for_the_disc();
  settings.path.margin = 0.1;
  int pauses = 0;
  for (int i = 0; i < 60; ++i) {
    const std::optional<Task> task = next_task();
    if (!task) continue;
    const Goal goal{.position = task->goal, .heading = {}};
    const Plan whole = Planner().plan(task->map, task->start, goal, settings);
    PlannerHooks hooks;
    hooks.pause = true;
    Plan plan = planner_.plan(task->map, task->start, goal, settings, hooks);
    for (int part = 0; plan.paused; ++part, ++pauses) {
      ASSERT_LT(part, 10);
      EXPECT_FALSE(plan.usable());
      const Plan begun = plan;
      hooks.begun = &begun;
      plan = planner_.plan(task->map, task->start, goal, settings, hooks);
    }
    ASSERT_EQ(plan.path_status, whole.path_status);
    ASSERT_EQ(plan.corridor_status, whole.corridor_status);
    ASSERT_EQ(plan.margin, whole.margin);
    ASSERT_EQ(plan.path.waypoints, whole.path.waypoints);
    ASSERT_EQ(plan.corridor.rectangles.size(), whole.corridor.rectangles.size());
    for (std::size_t n = 0; n < whole.corridor.rectangles.size(); ++n) {
      EXPECT_EQ(plan.corridor.rectangles[n].min, whole.corridor.rectangles[n].min);
      EXPECT_EQ(plan.corridor.rectangles[n].max, whole.corridor.rectangles[n].max);
    }
  }
  EXPECT_GT(pauses, 20);
}

TEST_F(PlannerLaws, ALimitedCorridorCoversTheBeginningOfThePath) {
  int cut = 0;
  for (int i = 0; i < 150; ++i) {
    const std::optional<Task> task = next_task();
    if (!task) continue;
    constexpr double kLength = 1.5;  // [m]
    const Goal goal{.position = task->goal, .heading = 0.3};
    const Plan plan = planner_.plan(
        task->map, task->start, goal, for_the_disc(),
        {.clock = {}, .build = {}, .fixed_margin = false, .corridor_length = kLength});
    if (!plan.usable()) continue;
    EXPECT_EQ(plan.path.waypoints.back(), task->goal) << "the path is whole";
    EXPECT_EQ(plan.whole, plan.path.length() <= kLength);
    if (plan.whole) {
      EXPECT_EQ(plan.goal.heading, goal.heading);
      continue;
    }
    ++cut;
    EXPECT_NEAR(plan.corridor.spans.back().to, kLength, 1e-9);
    EXPECT_LT((plan.goal.position - test::point_at(plan.path, kLength)).norm(), 1e-9);
    EXPECT_FALSE(plan.goal.heading) << "the heading is for the goal itself";
    EXPECT_TRUE(plan.corridor.admissible(plan.corridor.rectangles.size() - 1)
                    .contains(plan.goal.position, 1e-9));
  }
  EXPECT_GT(cut, 20);
}

}  // namespace
}  // namespace fairway
