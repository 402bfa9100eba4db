// SPDX-License-Identifier: Apache-2.0
// How soon a MovingObjectTracker notices people who walk.
#include <algorithm>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/perception/moving_object_tracker.hpp"
#include "tracked_hall.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

using test::Hall;

// In view from the first scan on, or stepping out from behind a post.
TEST(WalkingPeople, FollowsAPersonWhoWalksSlowly) {
  for (const double speed : {0.25, 0.32, 0.38, 0.45}) {
    for (const bool steps_out : {false, true}) {
      Hall hall(steps_out ? 3 : 2);
      if (steps_out) hall.put_post({1.5, -0.65}, 0.4);
      int followed = 0;
      int scans = 0;
      while (hall.time() < 6.0) {
        const MovingObstacle truth{.position = Vector2d(2.5, -1.2 + speed * hall.time()),
                                   .velocity = {0.0, speed},
                                   .radius = 0.26};
        const MovingObstacles seen = hall.scan({truth}, {}).tracker().obstacles();
        if (hall.time() < 4.5) continue;
        ++scans;
        if (seen.size() != 1) continue;
        ++followed;
        EXPECT_NEAR((seen[0].position - truth.position).norm(), 0.0, 0.15);
        EXPECT_NEAR((seen[0].velocity - truth.velocity).norm(), 0.0, 0.2);
      }
      EXPECT_EQ(followed, scans) << "speed " << speed << ", steps out " << steps_out;
    }
  }
}

// A person who stood is part of the map. The slower the walk, the more of it lies inside of the
// cells of the person before.
TEST(WalkingPeople, NoticesAPersonWhoSetsOffAfterAFewSteps) {
  constexpr double kStood = 2.0;  // [s]
  const std::vector<double> ranges = {1.5, 2.7, 4.0};
  std::size_t number = 0;
  for (const double speed : {0.21, 0.37, 0.46, 0.7, 1.1}) {
    for (double turn = 0.0; turn < 2.0; turn += 0.25) {  // of the walk from the view, in pi
      Hall hall(5);
      const double range = ranges[++number % ranges.size()];
      const double bearing = 0.3 * static_cast<double>(number % 5) - 0.6;
      const Vector2d velocity = speed * direction(turn * std::numbers::pi + bearing);
      double noticed = -1.0;
      int missed = 0;
      while (hall.time() < kStood + 0.6 / speed) {
        const double walked = std::max(0.0, hall.time() - kStood);
        const MovingObstacle truth{.position = range * direction(bearing) + walked * velocity,
                                   .velocity = walked > 0.0 ? velocity : Vector2d(0.0, 0.0),
                                   .radius = 0.28};
        const MovingObstacles seen = hall.scan({truth}, {}).tracker().obstacles();
        const bool found = seen.size() == 1 && (seen[0].position - truth.position).norm() < 0.1;
        if (found && noticed < 0.0) noticed = speed * walked;
        if (noticed >= 0.0 && !found) ++missed;
        if (walked == 0.0) {
          EXPECT_TRUE(seen.empty());
        }
      }
      constexpr double kFar = 0.22;   // [m]
      constexpr double kLate = 0.12;  // [s]; two scans and a half
      EXPECT_GT(noticed, 0.0) << "speed " << speed << ", turn " << turn << ", range " << range;
      EXPECT_LT(noticed, kFar + kLate * speed)
          << "speed " << speed << ", turn " << turn << ", range " << range;
      EXPECT_EQ(missed, 0) << "speed " << speed << ", turn " << turn << ", range " << range;
    }
  }
}

// Points of the wall that comes into view behind a person are not the person's.
TEST(WalkingPeople, FollowsAPersonWhoWalksOffFromAPostExactly) {
  constexpr double kStood = 2.0;  // [s]
  for (const double side : {-1.0, 1.0}) {
    Hall hall(8);
    hall.put_post({2.95, 0.42 * side}, 0.2);
    int followed = 0;
    while (hall.time() < kStood + 3.0) {
      const double walked = std::max(0.0, hall.time() - kStood);
      const Vector2d velocity(0.0, walked > 0.0 ? -0.37 * side : 0.0);
      const MovingObstacle truth{
          .position = Vector2d(2.7, 0.0) + walked * velocity, .velocity = velocity, .radius = 0.3};
      for (const MovingObstacle& seen : hall.scan({truth}, {}).tracker().obstacles()) {
        ++followed;
        EXPECT_LT((seen.position - truth.position).norm(), 0.06) << hall.time();
        EXPECT_LT((seen.velocity - truth.velocity).norm(), 0.3) << hall.time();
      }
    }
    EXPECT_GT(followed, 40);
  }
}

// Seen from behind, a person leaves the first outline slowly and into cells that are not yet known.
TEST(WalkingPeople, NoticesAPersonWhoWalksAway) {
  for (const double speed : {0.32, 0.45, 0.8}) {
    for (const double turn : {-0.15, 0.0, 0.1}) {  // of the walk from the view, in pi
      Hall hall(6);
      const Vector2d velocity = speed * direction(turn * std::numbers::pi);
      double noticed = -1.0;
      while (hall.time() < 2.0) {
        const MovingObstacle truth{.position = Vector2d(2.0, 0.0) + hall.time() * velocity,
                                   .velocity = velocity,
                                   .radius = 0.28};
        const double walked = speed * hall.time();
        const MovingObstacles seen = hall.scan({truth}, {}).tracker().obstacles();
        const bool found = seen.size() == 1 && (seen[0].position - truth.position).norm() < 0.15;
        if (found && noticed < 0.0) noticed = walked;
      }
      EXPECT_GT(noticed, 0.0) << "speed " << speed << ", turn " << turn;
      EXPECT_LT(noticed, 0.5) << "speed " << speed << ", turn " << turn;
    }
  }
}

}  // namespace
}  // namespace fairway
