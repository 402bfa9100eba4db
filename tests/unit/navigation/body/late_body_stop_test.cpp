// SPDX-License-Identifier: Apache-2.0
// A stop of a body that was proven keeps free of a wall, whichever base of the family drives it and
// whatever cycles of it are early or late.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/navigation/body/proof/body_stop.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/trajectory/tracking_law.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

const std::vector<Vector2d> kCorners{{0.8, 0.3}, {0.8, -0.3}, {-0.4, 0.3}, {-0.4, -0.3}};

// A half-plane of obstacles, at a distance from the origin in a direction.
struct Wall {
  double bearing = 0.0;   // of its normal, towards the wall [rad]
  double distance = 0.0;  // [m]

  [[nodiscard]] OccupancyGrid map() const {
    constexpr int kCells = 40;
    constexpr int kFree = 25;  // cells, of 1 m
    const Pose2 turned{.position = {0, 0}, .heading = bearing};
    const Vector2d local(kFree - distance, 0.5 * kCells);
    OccupancyGrid map({.width = kCells,
                       .height = kCells,
                       .resolution = 1.0,
                       .origin = {-transform(turned, local), bearing}});
    for (int y = 0; y < kCells; ++y) {
      for (int x = kFree; x < kCells; ++x)
        map.set({.x = x, .y = y}, CellState::Occupied);
    }
    return map;
  }

  [[nodiscard]] double clearance(const Pose2& pose) const {
    double reach = -1e9;
    for (const Vector2d& corner : kCorners)
      reach = std::max(reach, transform(pose, corner).dot(direction(bearing)));
    return distance - reach;
  }
};

// A base that drives a command and its stop, and what its next cycles may be like.
class BodyDrive {
 public:
  BodyDrive(test::Random& random, BaseKind kind) : random_(random) {
    base_.kind = kind;
    base_.linear_max = random.uniform(0.3, 2.0);
    base_.lateral_max = random.uniform(0.3, 1.0);
    base_.linear_acceleration = random.uniform(0.3, 3.0);
    base_.lateral_acceleration = random.uniform(0.3, 3.0);
    base_.angular_acceleration = random.uniform(0.6, 6.0);
    base_.steering_rate_max = random.uniform(0.3, 2.0);
    period_ = random.uniform(0.05, 0.2);
    longest_ = random.uniform(1.0, 2.0) * period_;
    shortest_ = random.chance(0.5) ? period_ : random.uniform(0.6, 1.0) * period_;
    sent_ = drawn(BaseInput{}, 10.0);
    input_ = drawn(sent_, period_);
    stop_.first = input_;
    BaseInput now = input_;
    while (stop_.count < 200 && !(stop_.count > 0 && is_at_rest(base_, now))) {
      now = limited_input(base_, now, resting_input(base_, now), period_);
      stop_.inputs[static_cast<std::size_t>(stop_.count++)] = now;
    }
  }

  // As DriveFollower proves it.
  [[nodiscard]] bool is_proven(const Wall& wall) const {
    const PreparedMap map(wall.map());
    const BodyClearance clearance(map.obstacles, map.distances,
                                  BodyShape::rectangle(1.2, 0.6, 0.8));
    for (const double hold : {period_, longest_, shortest_}) {
      const BodyManoeuvre manoeuvre{.current = sent_,
                                    .quick = sent_,
                                    .input = input_,
                                    .period = period_,
                                    .ramp = std::min(hold, period_),
                                    .hold = hold,
                                    .later = longest_ - hold,
                                    .earlier = hold - shortest_,
                                    .irregular = shortest_ < period_ || longest_ > period_};
      if (check_stop(base_, {}, manoeuvre, stop_, {.clearance = &clearance}) != StopVerdict::Free)
        return false;
    }
    return true;
  }

  // The nearest wall in a random direction at which the stop is proven; false for none.
  [[nodiscard]] bool find_wall(Wall& wall) const {
    wall.bearing = random_.uniform(-3.1, 3.1);
    double refused = 0.0;
    double proven = 15.0;
    wall.distance = proven;
    if (!is_proven(wall)) return false;
    while (proven - refused > 1e-4) {
      wall.distance = 0.5 * (proven + refused);
      (is_proven(wall) ? proven : refused) = wall.distance;
    }
    wall.distance = proven;
    return true;
  }

  // The least clearance of one base of the family, over cycles that are drawn.
  [[nodiscard]] double drive(const Wall& wall) const {
    constexpr double kFine = 1e-3;  // [s]
    const bool quick_linear = random_.chance(0.5);
    const bool quick_turn = random_.chance(0.5);
    const bool regular = random_.chance(0.2);
    Pose2 pose;
    BaseInput now = sent_;
    BaseInput begin = sent_;
    BaseInput command = input_;
    double least = wall.clearance(pose);
    double since = 0.0;  // `input_` was sent
    double cycle = 0.0;  // the time of the present command
    double ramp = std::min(period_, random_.chance(0.5) ? period_ : shortest_);
    double next = regular ? period_ : random_.uniform(shortest_, longest_);
    const auto follow = [&](double BaseInput::*axis, bool quick, double limit) {
      const double even =
          begin.*axis + (command.*axis - begin.*axis) * std::min(1.0, (cycle + kFine) / ramp);
      const double wanted = quick ? command.*axis : even;
      now.*axis += std::clamp(wanted - now.*axis, -limit * kFine, limit * kFine);
    };
    while (since < 60.0 && !(is_at_rest(base_, now) && is_at_rest(base_, command))) {
      const BaseInput before = now;
      follow(&BaseInput::linear, quick_linear, base_.linear_acceleration);
      follow(&BaseInput::lateral, quick_linear, base_.lateral_acceleration);
      follow(&BaseInput::turn, quick_turn,
             is_steered(base_) ? base_.steering_rate_max : base_.angular_acceleration);
      pose = driven(base_, pose, before, now, kFine);
      least = std::min(least, wall.clearance(pose));
      since += kFine;
      cycle += kFine;
      if (cycle < next - 0.5 * kFine) continue;
      begin = now;
      command = stop_.at(since / period_);
      ramp = std::min(next, period_);
      cycle = 0.0;
      next = regular ? period_ : random_.uniform(shortest_, longest_);
    }
    return least;
  }

 private:
  [[nodiscard]] BaseInput drawn(const BaseInput& from, double time) const {
    const double most = is_steered(base_) ? base_.steering_max : base_.angular_max;
    const double lateral = base_.kind == BaseKind::Omni ? base_.lateral_max : 0.0;
    return limited_input(base_, from,
                         {.linear = random_.uniform(0.2, 1.0) * base_.linear_max,
                          .lateral = random_.uniform(-lateral, lateral),
                          .turn = random_.uniform(-most, most)},
                         time);
  }

  test::Random& random_;
  BaseModel base_;
  double period_;
  double longest_;
  double shortest_;
  BaseInput sent_;
  BaseInput input_;
  BodyStop stop_;
};

class LateBodyStop : public testing::TestWithParam<BaseKind> {};

TEST_P(LateBodyStop, KeepsFreeOfTheWallThatItWasProvenFor) {
  test::Random random(7 + static_cast<std::uint64_t>(GetParam()));
  constexpr int kDrives = 300;
  constexpr int kBases = 8;
  double least = 1.0;
  for (int i = 0; i < kDrives; ++i) {
    const BodyDrive drive(random, GetParam());
    Wall wall;
    if (!drive.find_wall(wall)) continue;
    for (int k = 0; k < kBases; ++k)
      least = std::min(least, drive.drive(wall));
  }
  constexpr double kRounding = 1e-3;  // of the simulation in steps of 1 ms [m]
  EXPECT_GT(least, -kRounding);
  EXPECT_LT(least, 0.1) << "no drive came near its wall";
}

INSTANTIATE_TEST_SUITE_P(
    EveryBase,
    LateBodyStop,
    testing::Values(BaseKind::Unicycle, BaseKind::Car, BaseKind::Tricycle, BaseKind::Omni),
    [](const auto& kind) { return std::string(to_text(kind.param)); });

}  // namespace
}  // namespace fairway
