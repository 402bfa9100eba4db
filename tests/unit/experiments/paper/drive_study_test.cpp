// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/studies/drive_study.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace fairway::reproduction {
namespace {

TEST(DriveStudy, ThePapersMethodsDifferOnlyInTheirTargets) {
  Settings smpc = driver_settings(DriveCourse::Structured, DriverKind::Smpc);
  const Settings ismpc = driver_settings(DriveCourse::Structured, DriverKind::Ismpc);
  EXPECT_EQ(smpc.tracking.target_mode, TargetMode::OverlapCentroid);
  EXPECT_EQ(ismpc.tracking.target_mode, TargetMode::DualWaypoints);
  EXPECT_EQ(smpc.corridor.method, ismpc.corridor.method);
  EXPECT_EQ(smpc.mpc.horizon, ismpc.mpc.horizon);
  EXPECT_EQ(smpc.navigation.stall_timeout, ismpc.navigation.stall_timeout);
}

TEST(DriveStudy, SettingsAreValid) {
  for (std::size_t c = 0; c < kDriveCourses; ++c) {
    for (std::size_t k = 0; k < kDriverKinds; ++k) {
      EXPECT_TRUE(
          validate(driver_settings(static_cast<DriveCourse>(c), static_cast<DriverKind>(k))));
    }
  }
}

TEST(DriveStudy, DrivesKeepTheirBoundsWithoutContact) {
  const auto maps = compare_drivers(DriveCourse::Structured, 2, {.threads = 2});
  ASSERT_EQ(maps.size(), 2U);
  for (const DriveComparison& map : maps) {
    for (const Drive& drive : map.drives) {
      EXPECT_TRUE(drive.reached);
      EXPECT_FALSE(drive.collided);
      EXPECT_GE(drive.min_clearance, 0.0);
      EXPECT_LE(drive.greatest.linear, 1.0 + 1e-9);
      EXPECT_LE(drive.greatest.angular, 1.5 + 1e-9);
      EXPECT_GE(drive.least.angular, -1.5 - 1e-9);
      // No path is shorter than the straight one, less the tolerance at the goal.
      EXPECT_GT(drive.length, 27.0 * std::sqrt(2.0) - 0.3);
    }
  }
}

}  // namespace
}  // namespace fairway::reproduction
