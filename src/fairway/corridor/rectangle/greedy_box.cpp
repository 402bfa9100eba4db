// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/rectangle/greedy_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>

#include "fairway/base/simd.hpp"

namespace fairway {

namespace {

// Turns are counted from the start. In round n = 1, 2, ... the j-th of the four sides has turn 4 n
// + j.
constexpr float kNever = 4e6F;  // more turns than all sides make

// Rounds up to whole rounds (multiples of 4), with a tolerance of 1e-4 of a round. It adds a number
// so large that its last bit is worth 4.
Pack4f rounded_up(Pack4f turns) noexcept {
  constexpr float kLastBitIs4 = 50331648.0F;  // 2^25 + 2^24
  constexpr float kRoundUp = 4.0F * 0.4999F;
  return ((turns + kRoundUp) + kLastBitIs4) - kLastBitIs4;
}

// The points' coordinates along one axis. Each has the turn at which the side that moves towards it
// would pass it.
struct Axis {
  alignas(16) std::array<float, ObstaclePoints::kCapacity> at;  // NOLINT(*-member-init): filled as
                                                                // far as needed
  alignas(16) std::array<float, ObstaclePoints::kCapacity> turn;  // NOLINT(*-member-init)

  // Starts all sides: the upper one moves on turn `upper` of each round, the lower one on `lower`.
  void start(std::size_t count, const GreedySteps& steps, float upper, float lower) noexcept {
    const auto place = static_cast<float>(steps.start);
    const auto rate = static_cast<float>(4.0 / steps.step);
    for (std::size_t i = 0; i < count; i += 4) {
      const Pack4f c = load4(&at[i]);
      const Pack4f order = c > 0.0F ? four(upper) : four(lower);
      store4(rounded_up((max(c, -c) - place) * rate) + order, &turn[i]);
    }
  }

  // Continues the side in direction `sign` from `place` after turn `now`, at `rate` turns per cell;
  // 0 stops it.
  void go_on(std::size_t count, float sign, float place, float rate, float now) noexcept {
    for (std::size_t i = 0; i < count; i += 4) {
      const Pack4f outwards = sign * load4(&at[i]);
      const Pack4f before = load4(&turn[i]);
      const Pack4f later = rate > 0.0F ? rounded_up((outwards - place) * rate) + now : four(kNever);
      store4(((outwards > 0.0F) & (before >= now)) ? later : before, &turn[i]);
    }
  }
};

struct BoxSide {
  std::size_t axis;
  float sign;
  double place = 0.0;  // distance from the origin [cells]
  double step = 0.0;   // step per round [cells]; 0 once stopped
  double round = 0.0;  // round from which on it advances by `step`

  // Returns the turn, less the side's order, at which the side would pass the limit.
  [[nodiscard]] float limit_turn(double limit) const noexcept {
    if (step <= 0.0) return kNever;
    const double rounds = std::floor((limit - place) / step * (1.0 + 1e-12));
    return static_cast<float>(4.0 * (round + std::clamp(rounds + 1.0, 1.0, 9e5)));
  }
};

class BoxGrowth {
 public:
  BoxGrowth(const ObstaclePoints& points,
            const Eigen::Vector2d& along,
            const GreedySteps& steps) noexcept
      : count_(points.size()) {
    const auto c = static_cast<float>(along.x());
    const auto s = static_cast<float>(along.y());
    for (std::size_t i = 0; i < count_; i += 4) {
      const Pack4f x = load4(points.x() + i);
      const Pack4f y = load4(points.y() + i);
      store4(c * x + s * y, &axes_[0].at[i]);
      store4(c * y - s * x, &axes_[1].at[i]);
    }
    axes_[0].start(count_, steps, 3.0F, 1.0F);
    axes_[1].start(count_, steps, 0.0F, 2.0F);
    for (BoxSide& side : sides_) {
      side.place = steps.start;
      side.step = steps.step;
    }
  }

  // Returns the first turn at which a point would lie inside all sides.
  [[nodiscard]] float first_met() const noexcept {
    Pack4f first = four(2.0F * kNever);
    for (std::size_t i = 0; i < count_; i += 4) {
      // Missing points are NaN, and compare false.
      first = min(max(load4(&axes_[0].turn[i]), load4(&axes_[1].turn[i])), first);
    }
    return std::min(std::min(first[0], first[1]), std::min(first[2], first[3]));
  }

  // Returns the first turn at which a side would pass the limit.
  [[nodiscard]] float first_limited(double limit) const noexcept {
    float first = kNever;
    for (std::size_t j = 0; j < 4; ++j)
      first = std::min(first, sides_[j].limit_turn(limit) + static_cast<float>(j));
    return first;
  }

  // Performs all turns before `turn`, at which the side to move is blocked.
  void advance_to(float turn) noexcept {
    const auto number = static_cast<unsigned>(turn);
    BoxSide& side = sides_[number % 4U];
    const double round = number / 4U;
    side.place += side.step * (round - 1.0 - side.round);
    side.step = side.step > 1.0 ? 1.0 : 0.0;
    side.round = round;
    axes_[side.axis].go_on(count_, side.sign, static_cast<float>(side.place),
                           static_cast<float>(4.0 * side.step), turn);
  }

  [[nodiscard]] Box box() const noexcept {
    return {.min = {-sides_[1].place, -sides_[2].place}, .max = {sides_[3].place, sides_[0].place}};
  }

 private:
  std::size_t count_;
  std::array<Axis, 2> axes_;
  // The sides in the order in which Algorithm 1 advances them: top, left, bottom, right.
  std::array<BoxSide, 4> sides_{BoxSide{1, 1.0F}, BoxSide{0, -1.0F}, BoxSide{1, -1.0F},
                                BoxSide{0, 1.0F}};
};

}  // namespace

std::optional<Box> greedy_box(const ObstaclePoints& points,
                              const Eigen::Vector2d& along,
                              const GreedySteps& steps) noexcept {
  BoxGrowth growth(points, along, steps);
  if (growth.first_met() < 4.0F) return std::nullopt;
  while (true) {
    const float turn = std::min(growth.first_met(), growth.first_limited(steps.limit));
    if (turn >= kNever) break;
    growth.advance_to(turn);
  }
  return growth.box();
}

}  // namespace fairway
