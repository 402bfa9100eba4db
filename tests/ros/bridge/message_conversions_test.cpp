// SPDX-License-Identifier: Apache-2.0
// The conversions are templates over the messages of any middleware; here they run on plain structs
// with the same fields.
#include "bridge/message_conversions.hpp"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;
};
struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};
struct PoseMessage {
  Vector3 position;
  Quaternion orientation;
};
struct TwistMessage {
  Vector3 linear, angular;
};
struct MapMetaData {
  float resolution = 0.05F;
  std::uint32_t width = 0, height = 0;
  PoseMessage origin;
};

TEST(MessageConversions, KeepPosesBothWays) {
  for (const double heading : {0.0, 1.0, -3.0, std::numbers::pi}) {
    const Pose2 pose{.position = {1.5, -2.5}, .heading = heading};
    PoseMessage message;
    set_pose(pose, message);
    const Pose2 back = to_pose(message);
    EXPECT_EQ(back.position, pose.position);
    EXPECT_NEAR(std::remainder(back.heading - heading, 2.0 * std::numbers::pi), 0.0, 1e-12);
  }
}

TEST(MessageConversions, GiveTheHeadingOfATiltedRobot) {
  // Turned by 0.7 about z, then tilted by 0.2 about its own y axis.
  const Quaternion q{.x = -std::sin(0.35) * std::sin(0.1),
                     .y = std::cos(0.35) * std::sin(0.1),
                     .z = std::sin(0.35) * std::cos(0.1),
                     .w = std::cos(0.35) * std::cos(0.1)};
  EXPECT_NEAR(heading_of(q), 0.7, 1e-12);
}

TEST(MessageConversions, GiveNoHeadingForAnInvalidRotation) {
  EXPECT_TRUE(std::isnan(heading_of(Quaternion{.x = 0, .y = 0, .z = 0, .w = 0})));
  EXPECT_TRUE(std::isnan(heading_of(Quaternion{.x = 0, .y = 0, .z = NAN, .w = 1})));
  PoseMessage message;
  message.orientation.w = 0.0;
  EXPECT_FALSE(is_finite(to_pose(message)));
}

TEST(MessageConversions, KeepTwistsBothWays) {
  TwistMessage message;
  message.linear.y = 3.0;
  set_twist({.linear = 0.5, .angular = -0.25}, message);
  EXPECT_EQ(message.linear.y, 0.0);
  EXPECT_EQ(to_twist(message).linear, 0.5);
  EXPECT_EQ(to_twist(message).angular, -0.25);
}

TEST(MessageConversions, ReadGridsRowByRowFromTheLowerLeft) {
  MapMetaData info;
  info.width = 3;
  info.height = 2;
  set_pose({.position = {-1.0, 4.0}, .heading = 0.3}, info.origin);
  const std::vector<std::int8_t> percents{0, 100, -1, 25, 50, 65};
  const Expected<OccupancyGrid> grid = to_grid(info, percents);
  ASSERT_TRUE(grid) << grid.error().message;
  EXPECT_EQ(grid->frame().resolution, 0.05) << "0.05F means 0.05";
  EXPECT_EQ(grid->frame().origin.position, Eigen::Vector2d(-1.0, 4.0));
  EXPECT_NEAR(grid->frame().origin.heading, 0.3, 1e-12);
  EXPECT_EQ(grid->at({0, 0}), CellState::Free);
  EXPECT_EQ(grid->at({1, 0}), CellState::Occupied);
  EXPECT_EQ(grid->at({2, 0}), CellState::Unknown);
  EXPECT_EQ(grid->at({0, 1}), CellState::Free);
  EXPECT_EQ(grid->at({1, 1}), CellState::Unknown);
  EXPECT_EQ(grid->at({2, 1}), CellState::Occupied);
}

TEST(MessageConversions, RefuseInvalidGrids) {
  const std::vector<std::int8_t> cells(6);
  MapMetaData info;
  info.width = 3;
  info.height = 2;
  const auto message_of = [&](const MapMetaData& bad) {
    const Expected<OccupancyGrid> grid = to_grid(bad, cells);
    return grid ? std::string() : grid.error().message;
  };
  EXPECT_EQ(message_of(info), "");
  MapMetaData bad = info;
  bad.height = 3;
  EXPECT_EQ(message_of(bad), "map: data: expected 9 cells, found 6");
  bad = info;
  bad.width = 4000000000U;
  EXPECT_NE(message_of(bad).find("expected 1 to 32768, found 4000000000 x 2"), std::string::npos);
  bad = info;
  bad.resolution = NAN;
  EXPECT_NE(message_of(bad).find("info.resolution: expected a number from"), std::string::npos);
  bad = info;
  bad.origin.position.x = INFINITY;
  EXPECT_NE(message_of(bad).find("info.origin"), std::string::npos);
}

TEST(MessageConversions, WriteCellsAsTheyAreRead) {
  for (const CellState state : {CellState::Free, CellState::Occupied, CellState::Unknown})
    EXPECT_EQ(cell_of_percent(percent_of_cell(state)), state);
}

TEST(MessageConversions, GiveHeadingsAlongThePath) {
  const Path path{.waypoints = {{0, 0}, {0, 2}, {-1, 2}}};
  EXPECT_DOUBLE_EQ(waypoint_pose(path, 0).heading, 0.5 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(waypoint_pose(path, 1).heading, std::numbers::pi);
  EXPECT_DOUBLE_EQ(waypoint_pose(path, 2).heading, std::numbers::pi);
  EXPECT_DOUBLE_EQ(waypoint_pose(Path{.waypoints = {{1, 1}}}, 0).heading, 0.0);
}

}  // namespace
}  // namespace fairway::bridge
