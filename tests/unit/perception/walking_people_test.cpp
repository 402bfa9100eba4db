// SPDX-License-Identifier: Apache-2.0
// How soon a MovingObjectTracker notices people who walk.
#include <algorithm>
#include <numbers>

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
TEST(WalkingPeople, NoticesAPersonWhoWalksOffSlowly) {
  constexpr double kStood = 3.0;  // [s]
  for (const double speed : {0.21, 0.25, 0.32}) {
    for (const double turn : {0.5, 0.75, 1.0, 1.25, 1.5}) {  // of the walk from the view, in pi
      Hall hall(5);
      const Vector2d velocity = speed * direction(turn * std::numbers::pi);
      double noticed = -1.0;
      int missed = 0;
      while (hall.time() < kStood + 4.0) {
        const double walked = std::max(0.0, hall.time() - kStood);
        const MovingObstacle truth{.position = Vector2d(2.7, 0.0) + walked * velocity,
                                   .velocity = walked > 0.0 ? velocity : Vector2d(0.0, 0.0),
                                   .radius = 0.28};
        const MovingObstacles seen = hall.scan({truth}, {}).tracker().obstacles();
        const bool found = seen.size() == 1 && (seen[0].position - truth.position).norm() < 0.15;
        if (found && noticed < 0.0) noticed = speed * walked;
        if (noticed >= 0.0 && !found) ++missed;
      }
      EXPECT_GT(noticed, 0.0) << "speed " << speed << ", turn " << turn;
      EXPECT_LT(noticed, 0.58) << "speed " << speed << ", turn " << turn;
      EXPECT_EQ(missed, 0) << "speed " << speed << ", turn " << turn;
    }
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
