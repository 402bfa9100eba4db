// SPDX-License-Identifier: Apache-2.0
// When an object becomes a moving track, and how one that changes its motion is followed.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "fairway/perception/moving_object_tracker.hpp"
#include "tracked_hall.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;
using test::disc_at;
using test::Hall;

// A disc that moves when the first scan is taken was never seen to leave a free place.
TEST(MovingObjectTracker, ADiscThatMovesFromTheStartIsKnownWithinHalfASecond) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const double speed : {0.8, 1.6}) {
      Hall hall(seed);
      const double angle = 0.4 * (static_cast<double>(seed) - 3.5);
      const Vector2d velocity = speed * direction(std::numbers::pi + angle);
      double known = 10.0;  // [s]
      while (hall.time() < 1.0) {
        const MovingObstacle truth = disc_at(hall.time(), {3.0, 0.0}, velocity);
        const double now = hall.time();
        for (const MovingObstacle& track : hall.scan({truth}, {}).tracker().obstacles()) {
          const bool right = (track.position - truth.position).norm() < 0.3 &&
                             (track.velocity - velocity).norm() < 0.6;
          if (right) known = std::min(known, now);
        }
      }
      EXPECT_LE(known, 0.5) << "seed " << seed << ", speed " << speed;
    }
  }
}

// Two discs are one blob in the first scan. One of them comes towards the robot.
TEST(MovingObjectTracker, TwoDiscsThatOverlapAtTheStartAreSplit) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Hall hall(seed);
    double known = 10.0;  // [s]
    while (hall.time() < 1.5) {
      const double now = hall.time();
      const std::vector<MovingObstacle> truth = {disc_at(now, {2.6, 0.3}, {-1.2, 0.2}),
                                                 disc_at(now, {3.2, -0.4}, {0.3, -1.2})};
      for (const MovingObstacle& track : hall.scan(truth, {}).tracker().obstacles()) {
        const bool right = (track.position - truth[0].position).norm() < 0.3 &&
                           (track.velocity - truth[0].velocity).norm() < 0.7;
        if (right) known = std::min(known, now);
      }
    }
    EXPECT_LE(known, 0.5) << "seed " << seed;
  }
}

TEST(MovingObjectTracker, ADiscThatTurnsBackIsFollowedWithinThreeScans) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Hall hall(seed);
    constexpr double kTurn = 2.0;    // [s]
    constexpr double kScans = 0.18;  // [s]; three scans after the turn
    while (hall.time() < 3.0) {
      const double now = hall.time();
      const double along = now < kTurn ? now : 2.0 * kTurn - now;
      const MovingObstacle truth{.position = {3.0, -1.5 + 1.2 * along},
                                 .velocity = {0.0, now < kTurn ? 1.2 : -1.2},
                                 .radius = 0.5};
      const MovingObstacles seen = hall.scan({truth}, {}).tracker().obstacles();
      if (now < kTurn + kScans) continue;
      ASSERT_EQ(seen.size(), 1U) << now;
      EXPECT_LT((seen[0].velocity - truth.velocity).norm(), 0.6) << now << ", seed " << seed;
    }
  }
}

// What is not known of the velocity of a new object keeps the robot away from it.
TEST(MovingObjectTracker, AnUncertainVelocityMakesTheDiscLarger) {
  Hall hall(15);
  int seen = 0;
  while (hall.time() < 3.0) {
    const MovingObstacle truth = disc_at(hall.time(), {3.0, -1.5}, {0.0, 1.0});
    const MovingObjectTracker& tracker = hall.scan({truth}, {}).tracker();
    for (const MovingTrack& track : tracker.tracks()) {
      if (!track.moving) continue;
      ++seen;
      EXPECT_GT(track.velocity_sigma(), 0.1);
      EXPECT_GT(tracker.obstacles()[0].radius - track.radius, 0.15 * track.velocity_sigma());
    }
  }
  EXPECT_GT(seen, 30);
}

// A robot that drives an eight through 50 posts, with the errors of lidar and wheels.
TEST(MovingObjectTracker, AHallOfPostsHasNoMovingTrackThatLasts) {
  constexpr double kLongest = 0.45;  // [s]
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Hall hall(seed);
    test::Random random(seed + 40);
    const auto robot_at = [](double time) {
      const Vector2d at(5.0 * std::sin(0.35 * time), 2.5 * std::sin(0.7 * time));
      const Vector2d along(std::cos(0.35 * time), std::cos(0.7 * time));
      return Pose2{.position = at, .heading = std::atan2(along.y(), along.x())};
    };
    for (int i = 0; i < 50; ++i) {
      const Vector2d at(random.uniform(-10, 10), random.uniform(-7, 7));
      const double radius = random.uniform(0.05, 0.3);
      double least = 10.0;
      for (double t = 0.0; t < 18.0; t += 0.1)
        least = std::min(least, (robot_at(t).position - at).norm());
      if (least > 0.6 + radius) hall.put_post(at, radius);
    }
    Noise noise(seed);
    Odometry odometry({.most_scale_error = 0.01, .most_drift = 0.2 * std::numbers::pi / 180.0},
                      robot_at(0.0), noise);
    std::map<int, double> moving_for;  // by the number of the track [s]
    while (hall.time() < 15.0) {
      const Pose2 robot = robot_at(hall.time());
      odometry.move_to(robot);
      for (const MovingTrack& track : hall.scan({}, robot, odometry.pose()).tracker().tracks()) {
        if (track.moving) moving_for[track.id] += 0.05;
      }
    }
    for (const auto& [id, duration] : moving_for)
      EXPECT_LE(duration, kLongest) << "track " << id << ", seed " << seed;
  }
}

}  // namespace
}  // namespace fairway
