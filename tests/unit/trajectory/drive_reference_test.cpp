// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/drive_reference.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "fairway/trajectory/drive_planner.hpp"
#include "fairway/trajectory/tracking_law.hpp"

namespace fairway {
namespace {

constexpr double kRowStep = 0.02;

BaseModel reference_base(BaseKind kind) {
  BaseModel base;
  base.kind = kind;
  base.linear_min = -0.8;
  return base;
}

DriveReference reference_of(const BaseModel& base) {
  const BitGrid obstacles(GridFrame{.width = 240, .height = 160, .resolution = 0.05, .origin = {}},
                          false);
  const DistanceField distances(obstacles);
  const BodyClearance clearance(obstacles, distances, BodyShape::rectangle(1.2, 0.6, 0.8));
  const DrivePlan plan = plan_drive(clearance, base, {.position = {2.0, 2.0}, .heading = 0.5},
                                    {.position = {8.0, 5.0}, .heading = -1.0}, kRowStep, {});
  return DriveReference(base, plan.rows, kRowStep);
}

constexpr std::array<BaseKind, 4> kDrivenKinds{BaseKind::Unicycle, BaseKind::Car,
                                               BaseKind::Tricycle, BaseKind::Omni};

TEST(DriveReference, PosesAreThoseOfTheRows) {
  const DriveReference drive = reference_of(reference_base(BaseKind::Car));
  ASSERT_GT(drive.rows().size(), 100U);
  for (std::size_t k = 0; k < drive.rows().size(); ++k) {
    const Pose2 pose = drive.pose_at(static_cast<double>(k) * kRowStep + 1e-12);
    EXPECT_NEAR((pose.position - drive.rows()[k].pose.position).norm(), 0.0, 1e-9);
  }
  EXPECT_EQ(drive.pose_at(-1.0).position, drive.rows().front().pose.position);
  EXPECT_EQ(drive.pose_at(1e9).position, drive.rows().back().pose.position);
}

// From any phase and rate, braking ends at rest, and no axis changes faster than the base can.
TEST(DriveReference, BrakingKeepsTheAccelerationsOfTheBase) {
  for (const BaseKind kind : kDrivenKinds) {
    const BaseModel base = reference_base(kind);
    const DriveReference drive = reference_of(base);
    for (double phase = 0.0; phase < drive.duration(); phase += 0.37) {
      for (const double rate : {1.0, 0.5, -0.5}) {
        DriveProgress now{.phase = phase, .rate = rate};
        int steps = 0;
        for (; now.rate != 0.0 && steps < 1000; ++steps) {
          const PlanarTwist before = twist_of(base, drive.input_at(now));
          now = drive.advanced(now, 0.0, 0.02);
          const PlanarTwist after = twist_of(base, drive.input_at(now));
          constexpr double kRounding = 1.15;  // inputs are linear only between the rows' middles
          EXPECT_LE(std::abs(after.linear - before.linear),
                    kRounding * base.linear_acceleration * 0.02 + 2e-3)
              << to_text(kind) << " " << phase;
          EXPECT_LE(std::abs(after.angular - before.angular),
                    kRounding * base.angular_acceleration * 0.02 + 2e-2)
              << to_text(kind) << " " << phase;
        }
        EXPECT_LT(steps, 200) << to_text(kind);
      }
    }
  }
}

TEST(DriveReference, ASlowerSteeredBaseKeepsItsCurvature) {
  const BaseModel base = reference_base(BaseKind::Tricycle);
  const DriveReference drive = reference_of(base);
  for (double phase = 0.0; phase < drive.duration(); phase += 0.1) {
    const BaseInput fast = drive.input_at({.phase = phase, .rate = 1.0});
    const BaseInput slow = drive.input_at({.phase = phase, .rate = 0.25});
    EXPECT_EQ(fast.turn, slow.turn);
    EXPECT_NEAR(slow.linear, 0.25 * fast.linear, 1e-12);
  }
}

TEST(DriveReference, StaysWithinTheDrive) {
  const DriveReference drive = reference_of(reference_base(BaseKind::Omni));
  DriveProgress now;
  for (int i = 0; i < 100; ++i)
    now = drive.advanced(now, -1.0, 0.1);
  EXPECT_EQ(now.phase, 0.0);
  for (int i = 0; i < 1000; ++i)
    now = drive.advanced(now, 1.0, 0.1);
  EXPECT_EQ(now.phase, drive.duration());
  EXPECT_EQ(now.rate, 0.0);
}

// A drive whose rate is limited in its middle meets the limit there, and brakes in time.
TEST(DriveReference, ALimitedRateIsMetInTime) {
  for (const BaseKind kind : kDrivenKinds) {
    const BaseModel base = reference_base(kind);
    DriveReference drive = reference_of(base);
    std::vector<double> most(drive.rows().size(), 1.0);
    const std::size_t first = most.size() / 2;
    const std::size_t last = most.size() * 2 / 3;
    for (std::size_t k = first; k < last; ++k)
      most[k] = 0.3;
    drive.limit_rate(most);
    DriveProgress now;
    int steps = 0;
    for (; now.phase < drive.duration() && steps < 5000; ++steps) {
      const PlanarTwist before = twist_of(base, drive.input_at(now));
      now = drive.advanced(now, 1.0, kRowStep);
      const auto row = static_cast<std::size_t>(now.phase / kRowStep);
      if (row > first && row + 1 < last) {
        EXPECT_LE(now.rate, 0.3 + 0.02);
      }
      if (now.phase >= drive.duration()) break;
      const PlanarTwist after = twist_of(base, drive.input_at(now));
      EXPECT_LE(std::abs(after.linear - before.linear) / kRowStep,
                1.1 * base.linear_acceleration + 0.05);
    }
    EXPECT_GE(now.phase, drive.duration());
    EXPECT_GT(steps, static_cast<int>(most.size()) + 20);
  }
}

}  // namespace
}  // namespace fairway
