// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/greedy_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>

namespace fairway {

namespace {

constexpr int kLanes = 8;
using Lanes = Eigen::Array<float, kLanes, 1>;

constexpr float kNever = 4e6F;     // turns; more than all sides make
constexpr float kStopped = 1e30F;  // rate of a side that advances no more

// A side as the points see it. Plain numbers, so that all points are asked alike without a branch.
struct SideTurns {
  float place;  // distance from the origin [cells]
  float rate;   // turns per cell: four per step, as the sides take turns
  float order;  // its place among the four

  // The turn at which coordinates, counted outwards, come to lie behind the side; below 4 where
  // they do already. Turns are 4 n + order, so n is rounded up to whole rounds, but for 1e-4: by
  // adding a number so large that its last bit is worth 4.
  [[nodiscard]] Lanes operator()(const Lanes& outwards) const noexcept {
    constexpr float kLastBitIs4 = 50331648.0F;  // 2^25 + 2^24
    constexpr float kRoundUp = 4.0F * 0.4999F;
    return (((outwards - place) * rate + kRoundUp) + kLastBitIs4) - kLastBitIs4 + order;
  }
};

struct TurnedPoints {
  // Padded to whole lanes with points that are out of reach.
  alignas(32) std::array<float, ObstaclePoints::kCapacity + kLanes> x;
  alignas(32) std::array<float, ObstaclePoints::kCapacity + kLanes> y;
  std::size_t count = 0;

  TurnedPoints(const ObstaclePoints& points, const Eigen::Vector2d& along) noexcept {
    const auto c = static_cast<float>(along.x());
    const auto s = static_cast<float>(along.y());
    const float* const px = points.x();
    const float* const py = points.y();
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
      x[i] = c * px[i] + s * py[i];
      y[i] = c * py[i] - s * px[i];
    }
    count = (n + kLanes - 1) / kLanes * kLanes;
    for (std::size_t i = n; i < count; ++i)
      x[i] = y[i] = 1e6F;
  }

  // The first turn at which a point comes to lie behind all sides.
  [[nodiscard]] float first_turn(const SideTurns& right,
                                 const SideTurns& left,
                                 const SideTurns& top,
                                 const SideTurns& bottom) const noexcept {
    Lanes first = Lanes::Constant(2.0F * kNever);
    for (std::size_t i = 0; i < count; i += kLanes) {
      const Lanes px = Eigen::Map<const Lanes, Eigen::Aligned32>(x.data() + i);
      const Lanes py = Eigen::Map<const Lanes, Eigen::Aligned32>(y.data() + i);
      const Lanes sideways = right(px).max(left(-px));
      first = first.min(sideways.max(top(py).max(bottom(-py))));
    }
    return first.minCoeff();
  }
};

// The sides in the order in which Algorithm 1 advances them.
enum Turn : std::uint8_t { kTop, kLeft, kBottom, kRight };

struct Sides {
  std::array<double, 4> place;
  std::array<double, 4> step;  // 0: stopped
  std::size_t next = kTop;     // whose turn it is

  [[nodiscard]] SideTurns turns(Turn side) const noexcept {
    return {.place = static_cast<float>(place[side]),
            .rate = step[side] > 0.0 ? static_cast<float>(4.0 / step[side]) : kStopped,
            .order = static_cast<float>((side + 4U - next) % 4U)};
  }

  // The first turn at which a side would pass the limit.
  [[nodiscard]] float limit_turn(double limit) const noexcept {
    float first = 2.0F * kNever;
    for (std::size_t side = 0; side < 4; ++side) {
      if (step[side] <= 0.0) continue;
      const double room = (limit - place[side]) / step[side] * (1.0 + 1e-12);
      const auto round = static_cast<float>(std::clamp(std::floor(room) + 1.0, 1.0, 9e5));
      first = std::min(first, 4.0F * round + static_cast<float>((side + 4U - next) % 4U));
    }
    return first;
  }

  // Makes all turns before `turn`, at which its side finds no room.
  void advance_to(float turn) noexcept {
    const auto number = static_cast<unsigned>(turn);
    const unsigned rounds = number / 4U;
    const unsigned last = number % 4U;
    for (std::size_t side = 0; side < 4; ++side) {
      const unsigned order = static_cast<unsigned>(side + 4U - next) % 4U;
      place[side] += step[side] * (order < last ? rounds : rounds - 1U);
    }
    const std::size_t failed = (next + last) % 4U;
    step[failed] = step[failed] > 1.0 ? 1.0 : 0.0;
    next = (failed + 1U) % 4U;
  }
};

}  // namespace

std::optional<Box> greedy_box(const ObstaclePoints& points,
                              const Eigen::Vector2d& along,
                              const GreedySteps& steps) noexcept {
  const TurnedPoints turned(points, along);
  Sides sides;
  sides.place.fill(steps.start);
  sides.step.fill(steps.step);
  while (true) {
    const float met = turned.first_turn(sides.turns(kRight), sides.turns(kLeft), sides.turns(kTop),
                                        sides.turns(kBottom));
    if (met < 4.0F) return std::nullopt;
    const float turn = std::min(met, sides.limit_turn(steps.limit));
    if (turn >= kNever) break;
    sides.advance_to(turn);
  }
  return Box{.min = {-sides.place[kLeft], -sides.place[kBottom]},
             .max = {sides.place[kRight], sides.place[kTop]}};
}

}  // namespace fairway
