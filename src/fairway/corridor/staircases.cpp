// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/staircases.hpp"

#include <algorithm>
#include <limits>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr std::size_t kCapacity = ObstaclePoints::kCapacity;
constexpr float kNone = std::numeric_limits<float>::infinity();

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

// A height at which the top (or bottom) side can stop, and how far the box may then reach to both
// sides as far as the points on this half are concerned. All counted outwards.
struct Staircases::Level {
  float height;
  float left;
  float right;
};

struct Staircases::Levels {
  std::array<Level, 2 * kMostSteps + 1> levels;
  std::size_t count = 0;

  [[nodiscard]] const Level& operator[](std::size_t i) const noexcept { return levels[i]; }
};

// Takes the points of a quadrant in order of direction, from the `ahead` axis towards the `aside`
// axis. Points straight ahead of or aside from the core only lower the caps.
//
// A point further along in direction is less ahead or more aside, or both. So what came before
// rules a point out when it is less ahead, and what comes after when it is less aside: two running
// minima, without a branch that depends on the points.
void Staircases::extract(std::size_t quadrant,
                         const float* ahead,
                         const float* aside,
                         std::size_t count) {
  const std::size_t next = (quadrant + 1) % 4;
  const float core_ahead = core_reach_[quadrant];
  const float core_aside = core_reach_[next];
  float cap_ahead = cap_[quadrant];
  float cap_aside = cap_[next];
  std::array<float, kCapacity> candidate_aside;             // NOLINT(*-member-init): filled below
  constexpr std::array<float, 2> kPenalty = {0.0F, kNone};  // no branch this way
  float nearest_ahead = cap_ahead;
  bool core_hit = false;
  for (std::size_t i = 0; i < count; ++i) {
    const bool beyond_ahead = ahead[i] > core_ahead;
    const bool beyond_aside = aside[i] > core_aside;
    core_hit = core_hit | (!beyond_ahead & !beyond_aside);
    cap_ahead = std::min(cap_ahead, beyond_aside ? kNone : ahead[i]);
    cap_aside = std::min(cap_aside, beyond_ahead ? kNone : aside[i]);
    const float own = beyond_ahead & beyond_aside ? ahead[i] : kNone;
    candidate_aside[i] = aside[i] + kPenalty[own < nearest_ahead ? 0 : 1];
    nearest_ahead = std::min(nearest_ahead, own);
  }
  cap_[quadrant] = cap_ahead;
  cap_[next] = cap_aside;
  core_hit_ = core_hit_ | core_hit;
  std::array<Step, kCapacity + 1> steps;  // NOLINT(*-member-init): filled from the end
  std::size_t begin = count + 1;
  float nearest_aside = cap_aside;
  for (std::size_t i = count; i-- > 0;) {
    steps[begin - 1] = {ahead[i], candidate_aside[i]};
    const bool stays = candidate_aside[i] < nearest_aside;
    begin -= stays ? 1 : 0;
    nearest_aside = std::min(nearest_aside, candidate_aside[i]);
  }
  Staircase& staircase = quadrants_[quadrant];
  staircase.count = std::min(kMostSteps, count + 1 - begin);
  std::copy_n(steps.begin() + static_cast<std::ptrdiff_t>(begin), staircase.count,
              staircase.steps.begin());
}

void Staircases::assign(const ObstaclePoints& points,
                        const Vector2d& along,
                        const Box& core,
                        double longest_side) noexcept {
  core_ = core;
  longest_side_ = longest_side;
  core_hit_ = false;
  core_reach_ = {static_cast<float>(core.max.x()), static_cast<float>(core.max.y()),
                 static_cast<float>(-core.min.x()), static_cast<float>(-core.min.y())};
  for (std::size_t side = 0; side < 4; ++side)
    cap_[side] = static_cast<float>(longest_side) - core_reach_[(side + 2) % 4];

  // From the turned x-axis once around, so that each quadrant has its points together, in order;
  // with the signs that make both coordinates positive in the quadrant.
  std::array<float, kCapacity> x;  // NOLINT(*-member-init): filled below
  std::array<float, kCapacity> y;  // NOLINT(*-member-init): filled below
  const auto c = static_cast<float>(along.x());
  const auto s = static_cast<float>(along.y());
  const std::size_t n = points.size();
  const std::size_t start = points.first_from(along.x(), along.y());
  const auto turn = [&](const float* px, const float* py, std::size_t count, std::size_t to) {
    for (std::size_t i = 0; i < count; ++i) {
      x[to + i] = c * px[i] + s * py[i];
      y[to + i] = c * py[i] - s * px[i];
    }
  };
  turn(points.x() + start, points.y() + start, n - start, 0);
  turn(points.x(), points.y(), start, n - start);
  std::array<int, 3> count{};
  for (std::size_t i = 0; i < n; ++i) {
    count[0] += (x[i] > 0.0F) & (y[i] >= 0.0F);
    count[1] += (x[i] <= 0.0F) & (y[i] > 0.0F);
    count[2] += (x[i] < 0.0F) & (y[i] <= 0.0F);
  }
  const auto second = static_cast<std::size_t>(count[0]);
  const auto third = second + static_cast<std::size_t>(count[1]);
  const auto fourth = third + static_cast<std::size_t>(count[2]);
  for (std::size_t i = second; i < fourth; ++i)
    x[i] = -x[i];
  for (std::size_t i = third; i < n; ++i)
    y[i] = -y[i];
  extract(0, x.data(), y.data(), second);
  extract(1, y.data() + second, x.data() + second, third - second);
  extract(2, x.data() + third, y.data() + third, fourth - third);
  extract(3, y.data() + fourth, x.data() + fourth, n - fourth);
}

void Staircases::add(float x, float y) noexcept {
  std::size_t quadrant = 3;
  Step step{.ahead = -y, .aside = x};
  if (x > 0.0F && y >= 0.0F) {
    quadrant = 0;
    step = {.ahead = x, .aside = y};
  } else if (x <= 0.0F && y > 0.0F) {
    quadrant = 1;
    step = {.ahead = y, .aside = -x};
  } else if (x < 0.0F && y <= 0.0F) {
    quadrant = 2;
    step = {.ahead = -x, .aside = -y};
  }
  float& cap_ahead = cap_[quadrant];
  float& cap_aside = cap_[(quadrant + 1) % 4];
  const bool beyond_ahead = step.ahead > core_reach_[quadrant];
  const bool beyond_aside = step.aside > core_reach_[(quadrant + 1) % 4];
  if (!beyond_ahead || !beyond_aside) {
    core_hit_ = core_hit_ || (!beyond_ahead && !beyond_aside);
    if (beyond_ahead) cap_ahead = std::min(cap_ahead, step.ahead);
    if (beyond_aside) cap_aside = std::min(cap_aside, step.aside);
    return;
  }
  Staircase& staircase = quadrants_[quadrant];
  auto* const begin = staircase.steps.data();
  auto* const end = begin + staircase.count;
  auto* const at =
      std::find_if(begin, end, [&](const Step& other) { return other.aside >= step.aside; });
  if (at != begin && (at - 1)->ahead <= step.ahead) return;  // an earlier step rules it out
  auto* const after =
      std::find_if(at, end, [&](const Step& other) { return other.ahead < step.ahead; });
  if (after == at && staircase.count == kMostSteps) return;
  // It takes the place of the steps from `at` to `after`, which it rules out.
  if (after == at) {
    std::copy_backward(at, end, end + 1);
  } else {
    std::copy(after, end, at + 1);
  }
  *at = step;
  staircase.count = staircase.count + 1 - static_cast<std::size_t>(after - at);
}

// Merges the staircase of a quadrant with that of the next, which together are one half of what
// lies around the core: the upper one for quadrant 0, the lower one for quadrant 2. Both are walked
// outwards. The first has its heights in `aside` and bounds one side by its `ahead`; the second,
// walked backwards, has them in `ahead` and bounds the other side by its `aside`.
void Staircases::collect_levels(std::size_t quadrant, Levels& out) const noexcept {
  const Staircase& rising = quadrants_[quadrant];
  const Staircase& falling = quadrants_[quadrant + 1];
  const float height_cap = cap_[quadrant + 1];
  float rising_width = cap_[quadrant];
  float falling_width = cap_[(quadrant + 2) % 4];
  const bool upper = quadrant == 0;
  std::size_t i = 0;
  std::size_t j = falling.count;
  out.count = 0;
  const auto emit = [&](float height) {
    out.levels[out.count++] = {.height = height,
                               .left = upper ? falling_width : rising_width,
                               .right = upper ? rising_width : falling_width};
  };
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

std::optional<Box> Staircases::largest_box(double least_area) const noexcept {
  if (core_hit_) return std::nullopt;
  Levels tops;     // NOLINT(*-member-init): collect_levels fills it
  Levels bottoms;  // NOLINT(*-member-init): collect_levels fills it
  collect_levels(0, tops);
  collect_levels(2, bottoms);
  const auto limit = static_cast<float>(longest_side_);
  const float lowest = bottoms[bottoms.count - 1].height;
  // Outwards, levels never get wider. So below a top level the search starts at the last bottom
  // level that is still as wide: those before it are only lower boxes of the same width. That start
  // only moves outwards with the top.
  float best_area = static_cast<float>(least_area);
  const Level* best_top = nullptr;
  const Level* best_bottom = nullptr;
  std::size_t first = 0;
  for (std::size_t i = 0; i < tops.count; ++i) {
    const Level& top = tops[i];
    while (first + 1 < bottoms.count &&
           (bottoms[first + 1].left >= top.left) & (bottoms[first + 1].right >= top.right))
      ++first;
    const float widest = std::min(limit, top.left + top.right);
    if (widest * std::min(limit, top.height + lowest) <= best_area) continue;
    for (std::size_t j = first; j < bottoms.count; ++j) {
      const Level& bottom = bottoms[j];
      const float width = std::min(top.left, bottom.left) + std::min(top.right, bottom.right);
      const float area = std::min(limit, width) * std::min(limit, top.height + bottom.height);
      if (area <= best_area) continue;
      best_area = area;
      best_top = &top;
      best_bottom = &bottom;
    }
  }
  if (best_top == nullptr) return std::nullopt;
  Box box{.min = {-std::min(best_top->left, best_bottom->left), -best_bottom->height},
          .max = {std::min(best_top->right, best_bottom->right), best_top->height}};
  trim(box.min.x(), box.max.x(), core_.min.x(), core_.max.x(), longest_side_);
  trim(box.min.y(), box.max.y(), core_.min.y(), core_.max.y(), longest_side_);
  return box;
}

}  // namespace fairway
