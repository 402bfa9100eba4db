// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/largest_box.hpp"

#include <algorithm>
#include <array>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr std::size_t kCapacity = ObstaclePoints::kCapacity;

// The nearest points of one quadrant: none has another one nearer in both coordinates. In its own
// axes (`ahead`, `aside`, both positive in the quadrant) `ahead` falls and `aside` rises along it.
struct Staircase {
  struct Step {
    float ahead;
    float aside;
  };
  std::array<Step, kCapacity> steps;
  std::size_t count = 0;

  // Points come in order of direction, from the `ahead` axis towards the `aside` axis. So a later
  // point can never be both further ahead and less aside, and the last step is the only one that
  // can rule it out.
  void add(float ahead, float aside) noexcept {
    while (count > 0 && steps[count - 1].ahead >= ahead && steps[count - 1].aside >= aside)
      --count;
    if (count > 0 && steps[count - 1].ahead <= ahead) return;
    steps[count++] = {ahead, aside};
  }
};

// Where the sides could stop if there were nothing beside the core: set by the limit and by the
// points straight above, below, left and right of the core.
struct Caps {
  float left;
  float right;
  float bottom;
  float top;
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

struct Quadrants {
  Staircase upper_right;  // ahead = x, aside = y
  Staircase upper_left;   // ahead = y, aside = -x
  Staircase lower_left;   // ahead = -x, aside = -y
  Staircase lower_right;  // ahead = -y, aside = x
  Caps caps;
  bool core_hit = false;

  void add(float x, float y, float left, float right, float bottom, float top) noexcept {
    if (x > right) {
      if (y > top) {
        upper_right.add(x, y);
      } else if (y < bottom) {
        lower_right.add(-y, x);
      } else {
        caps.right = std::min(caps.right, x);
      }
    } else if (x < left) {
      if (y > top) {
        upper_left.add(y, -x);
      } else if (y < bottom) {
        lower_left.add(-x, -y);
      } else {
        caps.left = std::max(caps.left, x);
      }
    } else if (y > top) {
      caps.top = std::min(caps.top, y);
    } else if (y < bottom) {
      caps.bottom = std::max(caps.bottom, y);
    } else {
      core_hit = true;
    }
  }
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
  std::size_t i = 0;
  std::size_t j = falling.count;
  out.count = 0;
  while (true) {
    const float next_rising = i < rising.count ? rising.steps[i].aside : height_cap;
    const float next_falling = j > 0 ? falling.steps[j - 1].ahead : height_cap;
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
  return a.left <= b.left && a.right >= b.right;
}

// Tries the top levels with the bottom levels. Outwards, levels never get wider. So below a top
// level the search starts at the last bottom level that is still as wide (those before it are only
// lower boxes of the same width), and ends where the next top level is as wide as the bottom level
// (from there on it is the better top). Both bounds only move outwards with the top.
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
      if (i + 1 < tops.count && spans(tops.levels[i + 1], bottom)) break;
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
  const float* const px = points.x();
  const float* const py = points.y();
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = c * px[i] + s * py[i];
    y[i] = c * py[i] - s * px[i];
  }

  Quadrants quadrants;
  quadrants.caps = {.left = static_cast<float>(core.max.x() - longest_side),
                    .right = static_cast<float>(core.min.x() + longest_side),
                    .bottom = static_cast<float>(core.max.y() - longest_side),
                    .top = static_cast<float>(core.min.y() + longest_side)};
  // From the turned x-axis once around, so that each quadrant sees its points in order.
  const std::size_t start = points.first_from(along.x(), along.y());
  const auto left = static_cast<float>(core.min.x());
  const auto right = static_cast<float>(core.max.x());
  const auto bottom = static_cast<float>(core.min.y());
  const auto top = static_cast<float>(core.max.y());
  for (std::size_t i = start; i < n; ++i)
    quadrants.add(x[i], y[i], left, right, bottom, top);
  for (std::size_t i = 0; i < start; ++i)
    quadrants.add(x[i], y[i], left, right, bottom, top);
  if (quadrants.core_hit) return std::nullopt;

  const Caps& caps = quadrants.caps;
  Levels tops;     // NOLINT(*-member-init): collect_levels fills it
  Levels bottoms;  // NOLINT(*-member-init): collect_levels fills it
  collect_levels(quadrants.upper_right, quadrants.upper_left, caps.right, -caps.left, caps.top,
                 true, tops);
  collect_levels(quadrants.lower_left, quadrants.lower_right, -caps.left, caps.right, -caps.bottom,
                 false, bottoms);
  const Best best = best_pair(tops, bottoms, static_cast<float>(longest_side));
  Box box{.min = {best.left, best.bottom}, .max = {best.right, best.top}};
  trim(box.min.x(), box.max.x(), core.min.x(), core.max.x(), longest_side);
  trim(box.min.y(), box.max.y(), core.min.y(), core.max.y(), longest_side);
  return box;
}

}  // namespace fairway
