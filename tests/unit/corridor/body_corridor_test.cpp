// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/body_corridor.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kResolution = 0.05;  // [m]
constexpr double kWidth = 1.5;        // of both arms of the corner [m]

// An L of two corridors, from the left to the top: x below 6 + width, y above 1.
BitGrid corner() {
  BitGrid grid({.width = 160, .height = 160, .resolution = kResolution, .origin = {}}, true);
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 160; ++x) {
      const Vector2d at((x + 0.5) * kResolution, (y + 0.5) * kResolution);
      const bool lower = at.y() > 1.0 && at.y() < 1.0 + kWidth && at.x() < 5.0 + kWidth;
      const bool upper = at.x() > 5.0 && at.x() < 5.0 + kWidth && at.y() > 1.0;
      if (lower || upper) grid.set({.x = x, .y = y}, false);
    }
  }
  return grid;
}

// Along the lower arm, an arc about the inner corner, and up the other arm.
std::vector<Pose2> round_the_corner() {
  const double radius = 0.5 * kWidth;
  const Vector2d center(5.0, 1.0 + kWidth);
  std::vector<Pose2> poses;
  for (double x = 1.0; x < center.x(); x += 0.1)
    poses.push_back({.position = {x, center.y() - radius}, .heading = 0.0});
  for (double turn = 0.0; turn < 0.5 * std::numbers::pi; turn += 0.1)
    poses.push_back(
        {.position = center + radius * Vector2d(std::sin(turn), -std::cos(turn)), .heading = turn});
  for (double y = center.y(); y < 7.0; y += 0.1)
    poses.push_back({.position = {center.x() + radius, y}, .heading = 0.5 * std::numbers::pi});
  return poses;
}

void expect_covers(const BodyCorridor& corridor,
                   const BitGrid& obstacles,
                   const SlicedBody& body,
                   const std::vector<Pose2>& poses) {
  for (const BodyCorridor::Link& link : corridor.links)
    EXPECT_TRUE(is_free(obstacles, link.rectangle, 0.0));
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto pair = corridor.at(static_cast<int>(k));
    ASSERT_TRUE(pair) << k;
    for (std::size_t part = 0; part < 2; ++part) {
      for (const Vector2d& point : body.part(part)) {
        EXPECT_TRUE(
            corridor.links[(*pair)[part]].rectangle.contains(transform(poses[k], point), 1e-6))
            << k;
      }
    }
  }
}

TEST(BodyCorridor, AnEmptyHallNeedsOneRectangle) {
  const BitGrid hall({.width = 160, .height = 160, .resolution = kResolution, .origin = {}}, false);
  const SlicedBody body = SlicedBody::of({-0.6, -0.3}, {0.6, 0.3});
  const BodyCorridor corridor = build_body_corridor(hall, body, round_the_corner(), 0.02);
  EXPECT_EQ(corridor.links.size(), 1U);
  expect_covers(corridor, hall, body, round_the_corner());
}

TEST(BodyCorridor, AWideCornerNeedsTwoRectangles) {
  const BitGrid obstacles = corner();
  const SlicedBody body = SlicedBody::of({-0.3, -0.2}, {0.3, 0.2});
  const BodyCorridor corridor = build_body_corridor(obstacles, body, round_the_corner(), 0.02);
  EXPECT_LE(corridor.links.size(), 3U);
  expect_covers(corridor, obstacles, body, round_the_corner());
}

// A body that is longer than the corridor is wide fits into no rectangle of use on the arc: its
// front part enters the next one while its rear part is in the one before.
TEST(BodyCorridor, ALongBodyPassesACornerInSlices) {
  const BitGrid obstacles = corner();
  const SlicedBody body = SlicedBody::of({-0.7, -0.25}, {0.7, 0.25});
  const std::vector<Pose2> poses = round_the_corner();
  const BodyCorridor corridor = build_body_corridor(obstacles, body, poses, 0.0);
  expect_covers(corridor, obstacles, body, poses);
  EXPECT_LE(corridor.links.size(), 6U);
  int sliced = 0;
  for (int k = 0; k < static_cast<int>(poses.size()); ++k) {
    const auto pair = corridor.at(k);
    if (pair && (*pair)[0] != (*pair)[1]) ++sliced;
  }
  EXPECT_GT(sliced, 0);
}

TEST(BodyCorridor, HasNoLinkWhereTheBoxDoesNotFit) {
  BitGrid obstacles = corner();
  obstacles.set(obstacles.frame().cell_at({3.0, 1.75}), true);
  const SlicedBody body = SlicedBody::of({-0.3, -0.2}, {0.3, 0.2});
  const std::vector<Pose2> poses = round_the_corner();
  const BodyCorridor corridor = build_body_corridor(obstacles, body, poses, 0.02);
  EXPECT_FALSE(corridor.at(20));  // at (3, 1.75)
  EXPECT_TRUE(corridor.at(5));
  EXPECT_TRUE(corridor.at(static_cast<int>(poses.size()) - 1));
}

TEST(SlicedBody, BothPartsShareTheCutPoints) {
  for (const Vector2d& high : {Vector2d(0.8, 0.3), Vector2d(0.3, 0.8)}) {
    const SlicedBody body = SlicedBody::of(Vector2d(-0.2, -0.1), high);
    EXPECT_EQ(body.part(0)[2], body.part(1)[0]);
    EXPECT_EQ(body.part(0)[3], body.part(1)[1]);
    EXPECT_EQ(body.part(0)[0], Vector2d(-0.2, -0.1));
    EXPECT_EQ(body.part(1)[3], high);
  }
}

}  // namespace
}  // namespace fairway
