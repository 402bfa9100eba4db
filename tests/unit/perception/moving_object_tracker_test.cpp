// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/moving_object_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/geometry/oriented_rectangle.hpp"
#include "tracked_hall.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

using test::disc_at;
using test::Hall;

TEST(MovingObjectTracker, FollowsADiscThatCrosses) {
  test::Random random(1);
  for (int trial = 0; trial < 6; ++trial) {
    Hall hall(static_cast<std::uint64_t>(trial) + 1);
    const double speed = random.uniform(0.5, 2.0);
    const Vector2d velocity(0.0, random.chance(0.5) ? speed : -speed);
    const Vector2d start(random.uniform(2.5, 5.0), -velocity.y());
    int followed = 0;
    int scans = 0;
    while (hall.time() < 2.0) {
      const MovingObstacle truth = disc_at(hall.time(), start, velocity);
      const MovingObstacles seen = hall.scan({truth}, {}).tracker().obstacles();
      if (hall.time() < 0.75) continue;  // it must have moved to be distinguished from a post
      ++scans;
      if (seen.size() != 1) continue;
      ++followed;
      EXPECT_NEAR((seen[0].position - truth.position).norm(), 0.0, 0.15);
      EXPECT_NEAR(seen[0].radius, 0.5, 0.2);
      if (hall.time() > 1.2) {
        EXPECT_NEAR((seen[0].velocity - truth.velocity).norm(), 0.0, 0.45);
      }
    }
    EXPECT_GE(followed, scans - 3) << "speed " << speed;
  }
}

TEST(MovingObjectTracker, GivesNoTracksInAStaticWorld) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Hall hall(seed);
    test::Random random(seed);
    for (int i = 0; i < 60; ++i) {
      const Vector2d at(random.uniform(-8, 8), random.uniform(-8, 8));
      if (at.norm() > 1.5 && std::abs(at.y()) > 0.6) hall.put_post(at, random.uniform(0.075, 0.4));
    }
    Pose2 robot;
    int seen = 0;
    while (hall.time() < 5.0) {
      robot.position.x() = 1.2 * hall.time();
      robot.heading = 0.6 * std::sin(2.0 * hall.time());
      seen += static_cast<int>(hall.scan({}, robot).tracker().obstacles().size());
    }
    EXPECT_EQ(seen, 0);
  }
}

TEST(MovingObjectTracker, DriftOfThePoseMovesNoPost) {
  constexpr double kLongest = 0.5;  // [s]; of a track that counts as moving
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Hall hall(seed);
    test::Random random(seed + 20);
    for (int i = 0; i < 60; ++i) {
      const Vector2d at(random.uniform(-8, 8), random.uniform(-8, 8));
      if (at.norm() > 1.5 && std::abs(at.y()) > 0.6) hall.put_post(at, random.uniform(0.075, 0.4));
    }
    Noise noise(seed);
    Odometry odometry({.most_scale_error = 0.01, .most_drift = 0.2 * std::numbers::pi / 180.0},
                      {.position = {-6.0, 0.0}, .heading = 0.0}, noise);
    std::map<int, double> moving_for;  // by the number of the track [s]
    while (hall.time() < 8.0) {
      const Pose2 robot{.position = {1.5 * hall.time() - 6.0, 0.0},
                        .heading = 0.6 * std::sin(2.0 * hall.time())};
      odometry.move_to(robot);
      for (const MovingTrack& track : hall.scan({}, robot, odometry.pose()).tracker().tracks()) {
        if (track.moving) moving_for[track.id] += 0.05;
      }
    }
    for (const auto& [id, time] : moving_for)
      EXPECT_LT(time, kLongest) << "seed " << seed << ", track " << id;
  }
}

TEST(MovingObjectTracker, KeepsTheTrackOfAHiddenDisc) {
  Hall hall(7);
  hall.put_post({2.0, 0.0}, 0.5);
  const Vector2d start(4.5, -3.0);
  bool was_hidden = false;
  while (hall.time() < 5.0) {
    const MovingObstacle truth = disc_at(hall.time(), start, {0.0, 1.2});
    const Perception& seen = hall.scan({truth}, {});
    if (hall.time() < 1.0) continue;
    const bool hidden = std::abs(truth.position.y()) < 0.3;
    was_hidden = was_hidden || hidden;
    ASSERT_EQ(seen.tracker().obstacles().size(), 1U) << hall.time();
    const MovingObstacle& track = seen.tracker().obstacles()[0];
    EXPECT_LT((track.position - truth.position).norm(), 0.5);
    EXPECT_LT((track.position - truth.position).norm(), track.radius);
    EXPECT_EQ(seen.tracker().tracks()[0].id, seen.tracker().tracks().front().id);
  }
  EXPECT_TRUE(was_hidden);
}

TEST(MovingObjectTracker, AStoppedDiscBecomesPartOfTheMap) {
  Hall hall(9);
  const Vector2d start(3.0, -2.0);
  Vector2d stopped = Vector2d::Zero();
  while (hall.time() < 5.0) {
    const bool stands = hall.time() > 1.5;
    const MovingObstacle truth = disc_at(std::min(hall.time(), 1.5), start, {0.0, 1.0});
    stopped = truth.position;
    hall.scan({{.position = truth.position,
                .velocity = stands ? Vector2d(0, 0) : truth.velocity,
                .radius = 0.5}},
              {});
  }
  const Perception& seen =
      hall.scan({{.position = stopped, .velocity = {0, 0}, .radius = 0.5}}, {});
  EXPECT_EQ(seen.tracker().obstacles().size(), 0U);
  const RollingGrid& grid = seen.grid();
  const Vector2d front = stopped + 0.5 * (-stopped).normalized();
  bool near = false;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const CellIndex cell = grid.frame().cell_at(front);
      near = near || grid.occupied().blocked({cell.x + dx, cell.y + dy});
    }
  }
  EXPECT_TRUE(near);
}

// As the centre of a part of a wall does, when more of the wall comes into view.
TEST(MovingObjectTracker, AShiftThatEndsDoesNotCountForLong) {
  constexpr double kLongest = 0.5;  // [s]
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Hall hall(seed);
    while (hall.time() < 2.0)
      hall.scan({}, {});
    double counted = 0.0;
    double shifted_at = -1.0;
    double shift = 0.0;
    while (hall.time() < 5.0) {
      // It has appeared beside the robot, and moves only until it begins to count.
      const MovingObstacle truth{.position = Vector2d(2.0 + shift, 1.5), .radius = 0.3};
      const bool moves = !hall.scan({truth}, {}).tracker().obstacles().empty();
      if (moves && shifted_at < 0.0) shifted_at = hall.time();
      if (moves) counted += 0.05;
      if (hall.time() > 2.5 && shifted_at < 0.0) shift += 0.04;
    }
    EXPECT_GT(shifted_at, 0.0);
    EXPECT_LT(counted, kLongest) << "seed " << seed;
  }
}

TEST(MovingObjectTracker, AMovingDiscLeavesNoTrailInTheMap) {
  Hall hall(11);
  while (hall.time() < 4.0)
    hall.scan({disc_at(hall.time(), {3.0, -3.0}, {0.0, 1.5})}, {});
  const Perception& seen = hall.scan({disc_at(hall.time(), {3.0, -3.0}, {0.0, 1.5})}, {});
  const OrientedRectangle passed{
      .seed = {3.0, 0.0}, .orientation = 0.0, .min = {-0.6, -3.5}, .max = {0.6, 2.0}};
  int left = 0;
  for (int y = 0; y < seen.grid().frame().height; ++y) {
    for (int x = 0; x < seen.grid().frame().width; ++x) {
      if (passed.contains(seen.grid().frame().center({x, y})) &&
          seen.grid().occupied().blocked({x, y})) {
        ++left;
      }
    }
  }
  EXPECT_EQ(left, 0);
}

TEST(MovingObjectTracker, SeveralDiscsAreDistinguished) {
  Hall hall(13);
  std::size_t most = 0;
  while (hall.time() < 2.5) {
    const std::vector<MovingObstacle> truth = {disc_at(hall.time(), {2.5, -2.0}, {0.0, 1.2}),
                                               disc_at(hall.time(), {4.5, 3.0}, {0.2, -1.0}),
                                               disc_at(hall.time(), {-0.5, 4.0}, {1.0, 0.3}),
                                               disc_at(hall.time(), {1.0, -4.5}, {-0.9, 0.4})};
    const MovingObstacles seen = hall.scan(truth, {}).tracker().obstacles();
    most = std::max(most, seen.size());
    if (hall.time() < 1.0) continue;
    int found = 0;
    for (const MovingObstacle& t : truth) {
      for (const MovingObstacle& s : seen)
        found += (s.position - t.position).norm() < 0.25 ? 1 : 0;
    }
    EXPECT_GE(found, 3) << hall.time();
  }
  EXPECT_EQ(most, 4U);
}

// Two discs pass through each other at right angles to the view. They are one blob meanwhile, and
// each keeps its velocity.
TEST(MovingObjectTracker, DiscsThatPassThroughEachOtherKeepTheirVelocities) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Hall hall(seed);
    const double apart = 0.1 * static_cast<double>(seed);  // [m] across their lines
    int wrong = 0;
    while (hall.time() < 4.0) {
      const std::vector<MovingObstacle> truth = {
          disc_at(hall.time(), {3.0, -2.0}, {0.0, 1.0}),
          disc_at(hall.time(), {3.0 + apart, 2.0}, {0.0, -1.0})};
      const MovingObstacles seen = hall.scan(truth, {}).tracker().obstacles();
      if (hall.time() < 1.0) continue;
      for (const MovingObstacle& disc : truth) {
        const bool found = std::any_of(seen.begin(), seen.end(), [&](const MovingObstacle& track) {
          return (track.position - disc.position).norm() < 0.4 &&
                 (track.velocity - disc.velocity).norm() < 0.7;
        });
        if (!found) ++wrong;
      }
    }
    EXPECT_LE(wrong, 6) << "of 120, seed " << seed;
  }
}

}  // namespace
}  // namespace fairway
