// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/drive_planner.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/geometry/angle.hpp"
#include "fairway/trajectory/stopping_trajectory.hpp"
#include "fairway/trajectory/trajectory_tracker.hpp"
#include "support/random/random_world.hpp"
#include "support/runs/allocation_guard.hpp"

namespace fairway {
namespace {

constexpr double kPeriod = 0.02;

constexpr std::array<BaseKind, 4> kKinds{BaseKind::Unicycle, BaseKind::Car, BaseKind::Tricycle,
                                         BaseKind::Omni};

BaseModel base_of(BaseKind kind) {
  BaseModel base;
  base.kind = kind;
  base.linear_min = -0.8;
  if (kind == BaseKind::Unicycle)
    base.wheels = {.kind = WheelKind::Differential, .speed_max = 1.1, .track = 0.5};
  if (kind == BaseKind::Omni)
    base.wheels = {.kind = WheelKind::Mecanum, .speed_max = 1.1, .half_sum = 0.7};
  return base;
}

// An empty floor of 12 m x 8 m.
struct Floor {
  BitGrid obstacles{GridFrame{.width = 240, .height = 160, .resolution = 0.05, .origin = {}},
                    false};
  DistanceField distances{obstacles};
  BodyClearance clearance{obstacles, distances, BodyShape::rectangle(1.2, 0.6, 0.8)};
};

const Pose2 kStart{.position = {2.0, 2.0}, .heading = 0.5};
const Pose2 kGoal{.position = {8.0, 5.0}, .heading = -1.0};

TEST(Trajectory, DrivenAgreesWithManySmallSteps) {
  test::Random random(1);
  for (const BaseKind kind : kKinds) {
    const BaseModel base = base_of(kind);
    for (int trial = 0; trial < 20; ++trial) {
      const auto input = [&] {
        return BaseInput{random.uniform(-1, 1),
                         kind == BaseKind::Omni ? random.uniform(-1, 1) : 0.0,
                         random.uniform(-0.6, 0.6)};
      };
      const BaseInput first = input();
      const BaseInput last = first + 0.3 * input();
      const Pose2 fast = driven(base, kStart, first, last, 0.3);
      Pose2 slow = kStart;
      constexpr int kSteps = 1000;
      for (int i = 0; i < kSteps; ++i) {
        const double share = (i + 0.5) / kSteps;
        slow = moved(slow, twist_of(base, (1.0 - share) * first + share * last), 0.3 / kSteps);
      }
      EXPECT_NEAR((fast.position - slow.position).norm(), 0.0, 2e-5);
      EXPECT_NEAR(fast.heading - slow.heading, 0.0, 2e-5);
    }
  }
}

TEST(Trajectory, StoppingFollowsThePathWithinTheLimits) {
  for (const BaseKind kind : kKinds) {
    const BaseModel base = base_of(kind);
    const Floor floor;
    const BodyPathResult found = plan_body_path(floor.clearance, base, kStart, kGoal, {});
    ASSERT_EQ(found.status, BodyPathStatus::Found);
    const Trajectory trajectory = stopping_trajectory(base, found.path, 0.25);
    const Pose2 end = knot_poses(base, trajectory).back();
    EXPECT_NEAR((end.position - kGoal.position).norm(), 0.0, 1e-4) << to_text(kind);
    const std::vector<TrajectoryRow> rows = sampled(base, trajectory, kPeriod);
    EXPECT_LE(greatest_load(base, rows, kPeriod), 1.0 + 1e-9) << to_text(kind);
    EXPECT_NEAR((rows.back().pose.position - kGoal.position).norm(), 0.0, 2e-3) << to_text(kind);
    EXPECT_EQ(rows.back().twist.linear, 0.0);
  }
}

TEST(Trajectory, RowsOverALimitAreSeen) {
  const BaseModel base = base_of(BaseKind::Unicycle);
  std::vector<TrajectoryRow> rows(3);
  rows[1].twist.linear = 2.0 * base.linear_acceleration * kPeriod;
  EXPECT_NEAR(greatest_load(base, rows, kPeriod), 2.0, 1e-9);
}

TEST(DrivePlanner, DrivesAreFasterThanStoppingAndKeepTheLimits) {
  for (const BaseKind kind : kKinds) {
    const BaseModel base = base_of(kind);
    const Floor floor;
    DriveSettings settings;
    const DrivePlan fast = plan_drive(floor.clearance, base, kStart, kGoal, kPeriod, settings);
    settings.iterations = 0;
    const DrivePlan slow = plan_drive(floor.clearance, base, kStart, kGoal, kPeriod, settings);
    ASSERT_FALSE(fast.rows.empty());
    EXPECT_LT(static_cast<double>(fast.rows.size()), 0.9 * static_cast<double>(slow.rows.size()))
        << to_text(kind);
    EXPECT_LE(greatest_load(base, fast.rows, kPeriod), 1.0);
    EXPECT_TRUE(is_free(floor.clearance, fast.rows, kPeriod, fast.clearance));
    EXPECT_NEAR((fast.rows.back().pose.position - kGoal.position).norm(), 0.0, 2e-3);
    EXPECT_NEAR(shortest_turn(fast.rows.back().pose.heading, kGoal.heading), 0.0, 2e-3);
    // No faster than its greatest speed allows.
    const double straight = (kGoal.position - kStart.position).norm();
    EXPECT_GT(kPeriod * static_cast<double>(fast.rows.size()), straight / 1.3);
  }
}

TEST(TrajectoryTracker, RepeatsThePlanAndCorrectsAnErrorAtTheStart) {
  for (const BaseKind kind : kKinds) {
    const BaseModel base = base_of(kind);
    const Floor floor;
    const DrivePlan plan = plan_drive(floor.clearance, base, kStart, kGoal, kPeriod, {});
    for (const double error : {0.0, 0.03}) {
      TrajectoryTracker tracker(base, plan.rows, kPeriod);
      Pose2 pose = kStart;
      pose.position += Eigen::Vector2d(-error, error);
      BaseInput before;
      while (!tracker.finished()) {
        const BaseInput input = tracker.update(pose);
        const PlanarTwist twist = twist_of(base, input);
        EXPECT_LE(speed_load(base, twist), 1.0 + 1e-6);
        EXPECT_LE(std::abs(input.linear - before.linear),
                  base.linear_acceleration * kPeriod + 1e-12);
        before = input;
        pose = moved(pose, twist, kPeriod);
      }
      const double away = (pose.position - kGoal.position).norm();
      EXPECT_LT(away, error > 0.0 ? 0.015 : 2e-3) << to_text(kind);
    }
  }
}

TEST(TrajectoryTracker, StopsWithinTheLimitsOnAPoseThatIsNotFinite) {
  const BaseModel base = base_of(BaseKind::Unicycle);
  const Floor floor;
  const DrivePlan plan = plan_drive(floor.clearance, base, kStart, kGoal, kPeriod, {});
  TrajectoryTracker tracker(base, plan.rows, kPeriod);
  double speed = 0.0;
  for (int i = 0; i < 100; ++i)
    speed = tracker.update(plan.rows[static_cast<std::size_t>(i)].pose).linear;
  ASSERT_GT(speed, 0.1);
  const double next = tracker.update({.position = {std::nan(""), 0.0}, .heading = 0.0}).linear;
  EXPECT_NEAR(next, speed - base.linear_acceleration * kPeriod, 1e-9);
}

TEST(TrajectoryTracker, DoesNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "no allocation guard in this build";
  const BaseModel base = base_of(BaseKind::Car);
  const Floor floor;
  const DrivePlan plan = plan_drive(floor.clearance, base, kStart, kGoal, kPeriod, {});
  TrajectoryTracker tracker(base, plan.rows, kPeriod);
  const test::AllocationGuard guard;
  while (!tracker.finished())
    static_cast<void>(tracker.update(kStart));
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace fairway
