// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/obstacle_messages.hpp"

#include <gtest/gtest.h>

namespace fairway::nav2 {
namespace {

struct Xyz {
  double x = 0.0, y = 0.0, z = 0.0;
};
struct Point32 {
  float x = 0.0F, y = 0.0F, z = 0.0F;
};
struct TwistOf {
  Xyz linear, angular;
};

TEST(ObstacleMessages, OfPeopleAreDiscs) {
  struct Person {
    Xyz position, velocity;
  };
  struct {
    std::vector<Person> people{{.position = {1, 2, 0}, .velocity = {0.5, -0.5, 0}}};
  } message;
  const std::vector<MovingObstacle> read = read_people(message);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].position, Eigen::Vector2d(1, 2));
  EXPECT_EQ(read[0].velocity, Eigen::Vector2d(0.5, -0.5));
  EXPECT_EQ(read[0].radius, kPersonRadius);
}

TEST(ObstacleMessages, OfCostmapConverterCoverThePolygonsThatMove) {
  struct Obstacle {
    struct {
      std::vector<Point32> points;
    } polygon;
    double radius = 0.0;
    struct {
      TwistOf twist;
    } velocities;
  };
  struct {
    std::vector<Obstacle> obstacles;
  } message;
  Obstacle square{.polygon = {{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}}}};
  square.velocities.twist.linear = {.x = 1.0};
  Obstacle round{.polygon = {{{4, 4, 0}}}, .radius = 0.4};
  round.velocities.twist.linear = {.y = -0.3};
  const Obstacle wall{.polygon = {{{0, 0, 0}, {9, 0, 0}}}};
  message.obstacles = {square, wall, round, Obstacle{}};
  const std::vector<MovingObstacle> read = read_converted(message);
  ASSERT_EQ(read.size(), 2U) << "the wall does not move";
  EXPECT_LT((read[0].position - Eigen::Vector2d(1.5, 1.5)).norm(), 1e-6);
  EXPECT_NEAR(read[0].radius, std::sqrt(0.5), 1e-6);
  EXPECT_EQ(read[1].velocity, Eigen::Vector2d(0, -0.3));
  EXPECT_EQ(read[1].radius, 0.4);
}

TEST(ObstacleMessages, OfObjectsCoverTheirShapes) {
  struct Object {
    struct {
      Xyz position;
    } pose;
    TwistOf twist;
    struct {
      int type = 0;
      std::vector<double> dimensions;
    } shape;
  };
  struct {
    std::vector<Object> objects;
  } message;
  const auto add = [&](int type, std::vector<double> dimensions) {
    message.objects.push_back(
        {.pose = {{3, 4, 0}}, .twist = {{1, 0, 0}, {}}, .shape = {type, dimensions}});
  };
  add(1, {0.6, 0.8, 2.0});
  add(2, {0.7});
  add(3, {1.8, 0.2});
  add(1, {});
  add(0, {});
  const std::vector<MovingObstacle> read = read_objects(message);
  ASSERT_EQ(read.size(), 5U);
  EXPECT_NEAR(read[0].radius, 0.5, 1e-12);
  EXPECT_EQ(read[1].radius, 0.7);
  EXPECT_EQ(read[2].radius, 0.2);
  EXPECT_EQ(read[3].radius, kPersonRadius) << "a box without sizes";
  EXPECT_EQ(read[4].radius, kPersonRadius);
  EXPECT_EQ(read[0].velocity.x(), 1.0);
}

}  // namespace
}  // namespace fairway::nav2
