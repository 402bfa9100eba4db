// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/se2/body_path_planner.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/geometry/angle.hpp"
#include "fairway/path/se2/connections.hpp"
#include "fairway/path/se2/goal_distance.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

BaseModel base_of(BaseKind kind) {
  BaseModel base;
  base.kind = kind;
  base.linear_min = -0.8;
  return base;
}

constexpr std::array<BaseKind, 4> kKinds{BaseKind::Unicycle, BaseKind::Car, BaseKind::Tricycle,
                                         BaseKind::Omni};

// A floor of 8 m x 5 m with a wall across, in which there is a gap.
struct Hall {
  BitGrid obstacles;
  DistanceField distances;
  BodyClearance clearance;

  Hall(double gap, const BodyShape& body)
      : obstacles(made(gap)),
        distances(obstacles),
        clearance(obstacles, distances, body) {}

  static BitGrid made(double gap) {
    OccupancyGrid grid({.width = 160, .height = 100, .resolution = 0.05, .origin = {}});
    const int half = static_cast<int>(std::lround(0.5 * gap / 0.05));
    for (int y = 0; y < 100; ++y) {
      for (int x = 78; x < 82 && std::abs(2 * y + 1 - 100) > 2 * half; ++x)
        grid.set({x, y}, CellState::Occupied);
    }
    return BitGrid(grid);
  }
};

TEST(Connections, EndAtTheGoalAndCostNoLessThanTheBound) {
  test::Random random(3);
  std::vector<Connection> found;
  for (const BaseKind kind : kKinds) {
    const MotionCost cost(base_of(kind), 1.0);
    for (int trial = 0; trial < 200; ++trial) {
      const Pose2 from{.position = {random.uniform(-3, 3), random.uniform(-3, 3)},
                       .heading = random.uniform(-3, 3)};
      const Pose2 to{.position = {random.uniform(-3, 3), random.uniform(-3, 3)},
                     .heading = random.uniform(-3, 3)};
      find_connections(cost, from, to, found);
      ASSERT_FALSE(found.empty());
      for (const Connection& connection : found) {
        const Pose2 end = MotionPath{.start = from, .pieces = connection.pieces}.end();
        EXPECT_NEAR((end.position - to.position).norm(), 0.0, 1e-6);
        EXPECT_NEAR(shortest_turn(end.heading, to.heading), 0.0, 1e-6);
        EXPECT_GE(connection.cost, least_cost(cost, from, to) - 1e-6);
      }
    }
  }
}

TEST(BodyPath, EveryBaseDrivesThroughAGapThatItsDiscDoesNotFit) {
  for (const BaseKind kind : kKinds) {
    const Hall hall(1.0, BodyShape::rectangle(1.6, 0.6, 1.0));
    const Pose2 start{.position = {1.5, 2.0}, .heading = 1.0};
    const Pose2 goal{.position = {6.5, 3.0}, .heading = -0.5};
    const BodyPathResult result = plan_body_path(hall.clearance, base_of(kind), start, goal, {});
    ASSERT_EQ(result.status, BodyPathStatus::Found) << to_text(kind) << result.reason();
    EXPECT_NEAR((result.path.end().position - goal.position).norm(), 0.0, 1e-6);
    EXPECT_NEAR(shortest_turn(result.path.end().heading, goal.heading), 0.0, 1e-6);
    Pose2 pose = start;
    for (const MotionPiece& piece : result.path.pieces) {
      EXPECT_TRUE(std::isfinite(speed_load(base_of(kind), piece.twist))) << to_text(kind);
      EXPECT_TRUE(hall.clearance.is_free(pose, piece.twist, piece.amount, 0.0));
      pose = piece.from(pose);
    }
  }
}

TEST(BodyPath, GivesTheReasonWhereThereIsNone) {
  const Hall hall(0.5, BodyShape::rectangle(1.6, 0.6, 1.0));
  const Pose2 here{.position = {1.5, 2.0}, .heading = 0.0};
  const Pose2 there{.position = {6.5, 3.0}, .heading = 0.0};
  const Pose2 in_the_wall{.position = {4.0, 1.0}, .heading = 0.0};
  const BaseModel base = base_of(BaseKind::Omni);
  BodyPathSettings quick;
  quick.max_states = 3000;
  const auto status = [&](const Pose2& from, const Pose2& to) {
    return plan_body_path(hall.clearance, base, from, to, quick);
  };
  EXPECT_EQ(status(in_the_wall, there).status, BodyPathStatus::StartBlocked);
  EXPECT_EQ(status(here, in_the_wall).status, BodyPathStatus::GoalBlocked);
  const BodyPathResult none = status(here, there);
  EXPECT_NE(none.status, BodyPathStatus::Found);
  EXPECT_NE(none.reason().find("states searched"), std::string::npos);
}

TEST(BodyPath, AllSearchesTogetherKeepTheBudget) {
  const Hall hall(1.0, BodyShape::rectangle(1.6, 0.6, 1.0));
  BodyPathSettings settings;
  const auto plan = [&] {
    return plan_body_path(hall.clearance, base_of(BaseKind::Car),
                          {.position = {1.5, 2.0}, .heading = 1.0},
                          {.position = {6.5, 3.0}, .heading = -0.5}, settings);
  };
  EXPECT_EQ(plan().status, BodyPathStatus::Found);
  settings.total_states = 40;
  const BodyPathResult none = plan();
  EXPECT_EQ(none.status, BodyPathStatus::GaveUp);
  constexpr int kTurns = 64;  // states of the last turn of both trees
  EXPECT_LE(none.expanded, settings.total_states + kTurns);
}

TEST(BodyPath, TheSameInputGivesTheSamePathToTheBit) {
  const Hall hall(1.0, BodyShape::rectangle(1.6, 0.6, 1.0));
  const Pose2 start{.position = {1.5, 2.0}, .heading = 1.0};
  const Pose2 goal{.position = {6.5, 3.0}, .heading = -0.5};
  const BaseModel base = base_of(BaseKind::Car);
  const BodyPathResult a = plan_body_path(hall.clearance, base, start, goal, {});
  const BodyPathResult b = plan_body_path(hall.clearance, base, start, goal, {});
  ASSERT_EQ(a.path.pieces.size(), b.path.pieces.size());
  for (std::size_t i = 0; i < a.path.pieces.size(); ++i)
    EXPECT_EQ(a.path.pieces[i].amount, b.path.pieces[i].amount);
}

TEST(BodyPath, ReversingIsAvoidedWhereItIsDear) {
  const Hall hall(2.0, BodyShape::rectangle(1.0, 0.6, 0.7));
  const Pose2 start{.position = {2.5, 2.5}, .heading = 0.0};
  const Pose2 goal{.position = {1.2, 2.5}, .heading = 0.0};  // behind it
  const auto backwards = [&](double factor) {
    BodyPathSettings settings;
    settings.reverse_factor = factor;
    double sum = 0.0;
    const BodyPathResult result =
        plan_body_path(hall.clearance, base_of(BaseKind::Unicycle), start, goal, settings);
    for (const MotionPiece& piece : result.path.pieces)
      sum += piece.twist.linear < 0.0 ? piece.amount : 0.0;
    return sum;
  };
  EXPECT_NEAR(backwards(1.0), 1.3, 0.05);
  EXPECT_LT(backwards(20.0), 0.7);
}

TEST(GoalDistance, IsALowerBoundOfThePathsLength) {
  const Hall hall(1.0, BodyShape::rectangle(1.6, 0.6, 1.0));
  const Pose2 goal{.position = {6.5, 4.5}, .heading = 0.0};
  const Pose2 start{.position = {1.5, 4.0}, .heading = 0.0};
  const GoalDistance distance(hall.clearance, goal.position);
  const BodyPathResult result =
      plan_body_path(hall.clearance, base_of(BaseKind::Unicycle), start, goal, {});
  ASSERT_EQ(result.status, BodyPathStatus::Found);
  EXPECT_LE(distance.at(start.position), result.path.length());
  EXPECT_GT(distance.at(start.position), (start.position - goal.position).norm());
}

}  // namespace
}  // namespace fairway
