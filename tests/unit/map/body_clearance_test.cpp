// SPDX-License-Identifier: Apache-2.0
#include "fairway/map/body_clearance.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "random_body.hpp"
#include "support/random/random_world.hpp"
#include "support/runs/allocation_guard.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

using test::distance_to_part;
using test::random_body;

// The least distance over points of every blocked cell's outline and of the map's outside.
double slow_distance(const BitGrid& obstacles, const BodyShape& body, const Pose2& pose) {
  double least = std::numeric_limits<double>::infinity();
  const GridFrame& frame = obstacles.frame();
  for (const ConvexPart& part : body.parts()) {
    for (int i = 0; i < part.count; ++i) {
      const Vector2d g = frame.to_grid(transform(pose, part.vertex(i)));
      const double inside =
          std::min({g.x(), g.y(), frame.width - g.x(), frame.height - g.y()}) * frame.resolution;
      least = std::min(least, std::max(0.0, inside - part.radius));
    }
  }
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (!obstacles.blocked({x, y})) continue;
      for (int i = 0; i <= 8; ++i) {
        for (int j = 0; j <= 8; ++j) {
          const Vector2d point =
              inverse_transform(pose, frame.to_world({x + i / 8.0, y + j / 8.0}));
          for (const ConvexPart& part : body.parts())
            least = std::min(least, distance_to_part(part, point));
        }
      }
    }
  }
  return least;
}

struct RandomScene {
  BitGrid obstacles;
  DistanceField distances;
  BodyClearance clearance;
  double cell;

  RandomScene(test::Random& random, int side)
      : obstacles(test::random_world(random, side)),
        distances(obstacles),
        clearance(obstacles, distances, random_body(random, 4.0 * obstacles.frame().resolution)),
        cell(obstacles.frame().resolution) {}

  [[nodiscard]] Pose2 random_pose(test::Random& random) const {
    const GridFrame& frame = obstacles.frame();
    return {.position = frame.to_world({random.uniform(-2.0, frame.width + 2.0),
                                        random.uniform(-2.0, frame.height + 2.0)}),
            .heading = random.uniform(-4.0, 4.0)};
  }
};

TEST(BodyClearance, AgreesWithALookAtEveryCell) {
  test::Random random(11);
  int near = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const RandomScene scene(random, 48);
    for (int i = 0; i < 10; ++i) {
      const Pose2 pose = scene.random_pose(random);
      const double slow = slow_distance(scene.obstacles, scene.clearance.body(), pose);
      const double limit = 10.0 * scene.cell;
      const double fast = scene.clearance.distance(pose, limit);
      // The oracle samples outlines, and so sees up to a diagonal of its spacing too much.
      const double spacing = scene.cell / 8.0;
      EXPECT_LE(fast, std::min(slow, limit) + 1e-9);
      EXPECT_GE(fast, std::min(slow - spacing, limit) - 2e-4);
      EXPECT_LE(scene.clearance.distance_bound(pose), fast + 1e-4);
      if (slow > 0.0 && slow < limit) ++near;
    }
  }
  EXPECT_GT(near, 100);
}

TEST(BodyClearance, APoseThatIsNotFiniteIsNotFree) {
  test::Random random(12);
  const RandomScene scene(random, 48);
  const double nan = std::nan("");
  EXPECT_FALSE(scene.clearance.is_free(Pose2{.position = {nan, 0.0}}, 0.0));
  EXPECT_FALSE(scene.clearance.is_free(Pose2{.position = {1e300, 0.0}, .heading = 0.0}, 0.0));
  EXPECT_FALSE(scene.clearance.is_free(Pose2{}, PlanarTwist{.linear = nan}, 1.0, 0.0));
}

TEST(BodyClearance, AMotionIsFreeWhereEveryPoseOfItIs) {
  test::Random random(13);
  int free_motions = 0;
  int blocked_motions = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const RandomScene scene(random, 64);
    const Pose2 start = scene.random_pose(random);
    const double size = 4.0 * scene.cell;
    const PlanarTwist twist{size * random.uniform(-1, 1), size * random.uniform(-1, 1),
                            random.uniform(-1, 1)};
    const double clearance = random.chance(0.5) ? 0.0 : random.uniform(0.0, size);
    const double duration = random.uniform(0.0, 3.0);
    const bool proven = scene.clearance.is_free(start, twist, duration, clearance);
    bool sampled = true;
    bool generously = true;
    for (int i = 0; i <= 300; ++i) {
      const Pose2 pose = moved(start, twist, duration * i / 300.0);
      sampled = sampled && scene.clearance.is_free(pose, clearance);
      generously = generously &&
                   scene.clearance.is_free(pose, clearance + 2.0 * BodyClearance::kMotionTolerance);
    }
    EXPECT_TRUE(!proven || sampled);
    // With more clearance than the tolerance at the samples, and what lies between is small.
    const double between =
        0.5 * duration / 300.0 *
        scene.clearance.body().greatest_speed(twist.linear, twist.lateral, twist.angular);
    EXPECT_TRUE(proven || !generously || between > 0.5 * BodyClearance::kMotionTolerance);
    ++(proven ? free_motions : blocked_motions);
  }
  EXPECT_GT(free_motions, 30);
  EXPECT_GT(blocked_motions, 30);
}

TEST(BodyClearance, FindsAThinPostBetweenTwoFreePoses) {
  OccupancyGrid grid({.width = 100, .height = 100, .resolution = 0.05, .origin = {}});
  grid.set({50, 50}, CellState::Occupied);
  const BitGrid obstacles(grid);
  const DistanceField distances(obstacles);
  const BodyClearance clearance(obstacles, distances, BodyShape::rectangle(1.0, 0.2, 0.5));
  const Pose2 start{.position = {2.525, 1.0}, .heading = 0.0};
  const Pose2 end{.position = {2.525, 4.0}, .heading = 0.0};
  EXPECT_TRUE(clearance.is_free(start, 0.0));
  EXPECT_TRUE(clearance.is_free(end, 0.0));
  EXPECT_FALSE(clearance.is_free(start, twist_between(start, end), 1.0, 0.0));
}

TEST(BodyClearance, ContactsAreTheNearestPlacesAndTheirGradientIsRight) {
  test::Random random(17);
  int compared = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const RandomScene scene(random, 48);
    const Pose2 pose = scene.random_pose(random);
    const double reach = 3.0 * scene.cell;
    const double distance = scene.clearance.distance(pose, reach);
    std::array<BodyContact, BodyClearance::kMaxContacts> contacts;
    const std::size_t count = scene.clearance.contacts(pose, reach, contacts);
    if (distance <= 0.0 || count == 0) continue;
    double least = reach;
    for (std::size_t i = 0; i < count; ++i) {
      least = std::min(least, contacts[i].distance);
      EXPECT_NEAR(contacts[i].normal.norm(), 1.0, 1e-9);
      // Away from the obstacle the distance to it grows: here, the point of the body itself is at
      // that distance from a blocked cell.
      const Vector2d obstacle =
          contacts[i].point - (contacts[i].distance + 1e-9) * contacts[i].normal;
      const CellIndex cell = scene.obstacles.frame().cell_at(obstacle - 1e-6 * contacts[i].normal);
      EXPECT_TRUE(scene.obstacles.blocked(cell));
    }
    // The outside of the map is no contact, and may be nearer.
    EXPECT_GE(least, distance - 2e-4);
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

// A side that overlaps a post is pushed away where the post is, not at the side's end.
TEST(BodyClearance, AContactThatOverlapsLiesWhereItOverlaps) {
  OccupancyGrid grid({.width = 100, .height = 100, .resolution = 0.05, .origin = {}});
  grid.set({50, 50}, CellState::Occupied);
  const BitGrid obstacles(grid);
  const DistanceField distances(obstacles);
  const BodyClearance clearance(obstacles, distances, BodyShape::rectangle(2.0, 0.4, 1.0));
  const Vector2d post = grid.frame().center({50, 50});
  for (const double turn : {0.0, 0.1, -0.1, 0.7}) {
    const Pose2 pose{.position = post + rotated({0.3, 0.21}, turn), .heading = turn};
    std::array<BodyContact, BodyClearance::kMaxContacts> contacts;
    ASSERT_EQ(clearance.contacts(pose, 0.05, contacts), 1U) << turn;
    EXPECT_LT(contacts[0].distance, 0.0) << turn;
    EXPECT_LT((contacts[0].point - post).norm(), 0.06) << turn;
    EXPECT_GT(contacts[0].normal.dot(rotated(Vector2d::UnitY(), turn)), 0.99) << turn;
  }
}

TEST(BodyClearance, DoesNotAllocate) {
  if (!test::AllocationGuard::available) GTEST_SKIP() << "no allocation guard in this build";
  test::Random random(19);
  const RandomScene scene(random, 64);
  const Pose2 pose = scene.random_pose(random);
  std::array<BodyContact, BodyClearance::kMaxContacts> contacts;
  const test::AllocationGuard guard;
  bool any = scene.clearance.is_free(pose, {0.3, 0.1, 0.2}, 1.0, 0.01);
  any = scene.clearance.contacts(pose, 1.0, contacts) > 0 || any;
  static_cast<void>(any);
  EXPECT_EQ(guard.count(), 0U);
}

}  // namespace
}  // namespace fairway
