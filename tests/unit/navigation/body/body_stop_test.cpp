// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/proof/body_stop.hpp"

#include <gtest/gtest.h>

#include "fairway/planning/planner.hpp"

namespace fairway {
namespace {

// A robot that drives at 1 m/s towards a wall and brakes by 0.1 m/s in each period of 0.1 s.
class StopBeforeAWall : public testing::Test {
 protected:
  StopBeforeAWall() {
    constexpr int kPeriods = 10;
    for (int i = 1; i <= kPeriods; ++i)
      stop_.inputs[static_cast<std::size_t>(stop_.count++)].linear = 1.0 - 0.1 * i;
  }

  static OccupancyGrid wall_at_5_m() {
    OccupancyGrid map(GridFrame{.width = 120, .height = 60, .resolution = 0.05, .origin = {}});
    for (int y = 0; y < 60; ++y)
      map.set({.x = 100, .y = y}, CellState::Occupied);
    return map;
  }

  // Whether the body, which reaches 0.6 m ahead, stops with its front `distance` [m] from the wall
  // where the cycle is on time and is free where the stop begins `held` [s] later.
  [[nodiscard]] StopVerdict check(double distance, double held) const {
    const double braking = 0.1 + 0.5;  // a period at 1 m/s, and 1 m/s at 1 m/s2
    const Pose2 pose{.position = {5.0 - 0.6 - braking - distance, 1.5}, .heading = 0.0};
    const BaseInput input{.linear = 1.0};
    return check_stop(BaseModel{}, pose,
                      {.current = input, .quick = input, .input = input, .hold = 0.1 + held}, stop_,
                      {.clearance = &clearance_});
  }

  PreparedMap map_{wall_at_5_m()};
  BodyShape body_ = BodyShape::rectangle(1.2, 0.6, 0.6);
  BodyClearance clearance_{map_.obstacles, map_.distances, body_};
  BodyStop stop_;
};

TEST_F(StopBeforeAWall, ACycleThatIsLateDrivesFurther) {
  EXPECT_EQ(check(0.03, 0.0), StopVerdict::Free);
  EXPECT_EQ(check(0.03, 0.05), StopVerdict::HitsStatic) << "5 cm further";
  EXPECT_EQ(check(0.07, 0.05), StopVerdict::Free);
  EXPECT_EQ(check(0.07, 0.13), StopVerdict::HitsStatic);
  EXPECT_EQ(check(-0.02, 0.0), StopVerdict::HitsStatic);
}

}  // namespace
}  // namespace fairway
