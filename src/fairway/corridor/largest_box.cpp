// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/largest_box.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr std::size_t kCapacity = ObstaclePoints::kCapacity;

constexpr float kNone = std::numeric_limits<float>::infinity();

// The nearest points of one quadrant: none has another one nearer in both coordinates. In its own
// axes (`ahead`, `aside`, both positive in the quadrant) `ahead` falls and `aside` rises along it.
struct Staircase {
  struct Step {
    float ahead;
    float aside;
  };
  std::array<Step, kCapacity + 1> steps;
  std::size_t begin = 0;
  std::size_t end = 0;

  // Takes the points of the quadrant in order of direction, from the `ahead` axis towards the
  // `aside` axis: signs times values. Points straight ahead of or aside from the core, which
  // reaches to `core`, only lower the caps.
  //
  // A point further along in direction is less ahead or more aside, or both. So what came before
  // rules a point out when it is less ahead, and what comes after when it is less aside: two
  // running minima, without a branch that depends on the points.
  void extract(const float* ahead_values,
               float ahead_sign,
               const float* aside_values,
               float aside_sign,
               std::size_t count,
               const Step& core,
               Step& caps,
               bool& core_hit) noexcept {
    std::array<float, kCapacity> candidate_aside;             // NOLINT(*-member-init): filled below
    std::array<float, kCapacity> candidate_ahead;             // NOLINT(*-member-init): filled below
    constexpr std::array<float, 2> kPenalty = {0.0F, kNone};  // no branch this way
    float nearest_ahead = caps.ahead;
    for (std::size_t i = 0; i < count; ++i) {
      const float ahead = ahead_sign * ahead_values[i];
      const float aside = aside_sign * aside_values[i];
      const bool beyond_ahead = ahead > core.ahead;
      const bool beyond_aside = aside > core.aside;
      core_hit = core_hit | (!beyond_ahead & !beyond_aside);
      caps.ahead = std::min(caps.ahead, beyond_aside ? kNone : ahead);
      caps.aside = std::min(caps.aside, beyond_ahead ? kNone : aside);
      const float own = beyond_ahead & beyond_aside ? ahead : kNone;
      candidate_ahead[i] = ahead;
      candidate_aside[i] = aside + kPenalty[own < nearest_ahead ? 0 : 1];
      nearest_ahead = std::min(nearest_ahead, own);
    }
    float nearest_aside = caps.aside;
    end = count + 1;
    begin = end;
    for (std::size_t i = count; i-- > 0;) {
      steps[begin - 1] = {candidate_ahead[i], candidate_aside[i]};
      const bool stays = candidate_aside[i] < nearest_aside;
      begin -= stays ? 1 : 0;
      nearest_aside = std::min(nearest_aside, candidate_aside[i]);
    }
  }
};

// A height at which the top (or bottom) side can stop, and how far left and right the box may then
// reach as far as the points on this half are concerned. Heights are counted outwards.
struct Level {
  float height;
  float left;
  float right;
};

struct Levels {
  std::array<Level, 2 * kCapacity + 1> levels;
  std::size_t count = 0;
};

// Merges the two staircases of one half, both walked outwards. `rising` has its heights in `aside`
// (walked forwards), `falling` in `ahead` (walked backwards). Widths are counted outwards too:
// `rising` bounds one side by its `ahead`, `falling` the other by its `aside`.
void collect_levels(const Staircase& rising,
                    const Staircase& falling,
                    float rising_cap,
                    float falling_cap,
                    float height_cap,
                    bool rising_is_right,
                    Levels& out) noexcept {
  float rising_width = rising_cap;
  float falling_width = falling_cap;
  const auto emit = [&](float height) {
    out.levels[out.count++] = {height, rising_is_right ? -falling_width : -rising_width,
                               rising_is_right ? rising_width : falling_width};
  };
  std::size_t i = rising.begin;
  std::size_t j = falling.end;
  out.count = 0;
  while (true) {
    const float next_rising = i < rising.end ? rising.steps[i].aside : height_cap;
    const float next_falling = j > falling.begin ? falling.steps[j - 1].ahead : height_cap;
    const float height = std::min(next_rising, next_falling);
    if (height >= height_cap) break;
    if (next_rising <= next_falling) {
      const float width = rising.steps[i++].ahead;
      if (width >= rising_width) continue;  // beyond the cap: no obstacle at all
      emit(height);
      rising_width = width;
    } else {
      const float width = falling.steps[--j].aside;
      if (width >= falling_width) continue;
      emit(height);
      falling_width = width;
    }
  }
  emit(height_cap);
}

struct Best {
  float area = -1.0F;
  float left = 0.0F;
  float right = 0.0F;
  float bottom = 0.0F;
  float top = 0.0F;
};

// Whether level `a` reaches at least as far to both sides as `b`.
bool spans(const Level& a, const Level& b) noexcept {
  return (a.left <= b.left) & (a.right >= b.right);
}

// Tries the top levels with the bottom levels. Outwards, levels never get wider. So below a top
// level the search starts at the last bottom level that is still as wide: those before it are only
// lower boxes of the same width. That start only moves outwards with the top.
Best best_pair(const Levels& tops, const Levels& bottoms, float limit) noexcept {
  Best best;
  std::size_t first = 0;
  for (std::size_t i = 0; i < tops.count; ++i) {
    const Level& top = tops.levels[i];
    while (first + 1 < bottoms.count && spans(bottoms.levels[first + 1], top))
      ++first;
    for (std::size_t j = first; j < bottoms.count; ++j) {
      const Level& bottom = bottoms.levels[j];
      const float right = std::min(top.right, bottom.right);
      const float left = std::max(top.left, bottom.left);
      const float area =
          std::min(limit, right - left) * std::min(limit, top.height + bottom.height);
      if (area > best.area) best = {area, left, right, -bottom.height, top.height};
    }
  }
  return best;
}

// The part of [low, high] that is at most `limit` long, holds [core_low, core_high] and is as
// central about it as it can be.
void trim(double& low, double& high, double core_low, double core_high, double limit) noexcept {
  const double excess = high - low - limit;
  if (excess <= 0.0) return;
  const double middle = 0.5 * (core_low + core_high);
  low = std::clamp(middle - 0.5 * limit, low, low + excess);
  high = low + limit;
}

}  // namespace

std::optional<Box> largest_box(const ObstaclePoints& points,
                               const Vector2d& along,
                               const Box& core,
                               double longest_side) noexcept {
  std::array<float, kCapacity> x;  // NOLINT(*-member-init): filled below
  std::array<float, kCapacity> y;  // NOLINT(*-member-init): filled below
  const auto c = static_cast<float>(along.x());
  const auto s = static_cast<float>(along.y());
  const std::size_t n = points.size();
  // From the turned x-axis once around, so that each quadrant has its points together, in order.
  const std::size_t start = points.first_from(along.x(), along.y());
  const auto turn = [&](const float* px, const float* py, std::size_t count, std::size_t to) {
    for (std::size_t i = 0; i < count; ++i) {
      x[to + i] = c * px[i] + s * py[i];
      y[to + i] = c * py[i] - s * px[i];
    }
  };
  turn(points.x() + start, points.y() + start, n - start, 0);
  turn(points.x(), points.y(), start, n - start);
  std::array<int, 4> count{};
  for (std::size_t i = 0; i < n; ++i) {
    count[0] += (x[i] > 0.0F) & (y[i] >= 0.0F);
    count[1] += (x[i] <= 0.0F) & (y[i] > 0.0F);
    count[2] += (x[i] < 0.0F) & (y[i] <= 0.0F);
  }
  count[3] = static_cast<int>(n) - count[0] - count[1] - count[2];

  // Outwards from the origin, the core and the caps in the directions +x, +y, -x, -y.
  const std::array<float, 4> core_reach = {
      static_cast<float>(core.max.x()), static_cast<float>(core.max.y()),
      static_cast<float>(-core.min.x()), static_cast<float>(-core.min.y())};
  std::array<float, 4> cap = {static_cast<float>(core.min.x() + longest_side),
                              static_cast<float>(core.min.y() + longest_side),
                              static_cast<float>(longest_side - core.max.x()),
                              static_cast<float>(longest_side - core.max.y())};
  std::array<Staircase, 4> quadrants;  // counter-clockwise from the upper right one
  bool core_hit = false;
  std::size_t first = 0;
  for (std::size_t q = 0; q < 4; ++q) {
    const bool upright = q % 2 == 0;  // ahead lies along x
    const float ahead_sign = q == 0 || q == 1 ? 1.0F : -1.0F;
    const float aside_sign = q == 0 || q == 3 ? 1.0F : -1.0F;
    const std::size_t next = (q + 1) % 4;
    Staircase::Step limits{.ahead = cap[q], .aside = cap[next]};
    quadrants[q].extract(
        (upright ? x : y).data() + first, ahead_sign, (upright ? y : x).data() + first, aside_sign,
        static_cast<std::size_t>(count[q]), {core_reach[q], core_reach[next]}, limits, core_hit);
    cap[q] = limits.ahead;
    cap[next] = limits.aside;
    first += static_cast<std::size_t>(count[q]);
  }
  if (core_hit) return std::nullopt;

  Levels tops;     // NOLINT(*-member-init): collect_levels fills it
  Levels bottoms;  // NOLINT(*-member-init): collect_levels fills it
  collect_levels(quadrants[0], quadrants[1], cap[0], cap[2], cap[1], true, tops);
  collect_levels(quadrants[2], quadrants[3], cap[2], cap[0], cap[3], false, bottoms);
  const Best best = best_pair(tops, bottoms, static_cast<float>(longest_side));
  Box box{.min = {best.left, best.bottom}, .max = {best.right, best.top}};
  trim(box.min.x(), box.max.x(), core.min.x(), core.max.x(), longest_side);
  trim(box.min.y(), box.max.y(), core.min.y(), core.max.y(), longest_side);
  return box;
}

}  // namespace fairway
