// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/rectangle/largest_box.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "fairway/base/contract.hpp"
#include "fairway/base/simd.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr std::size_t kCapacity = ObstaclePoints::kCapacity;
constexpr float kFar = 1e9F;  // beyond every point and every side [cells]
constexpr std::size_t kBits = 32;

// Quadrants of the turned frame, counter-clockwise from the upper right one. In each, `ahead` is
// measured along the axis that it begins with (+x, +y, -x, -y) and `aside` along the axis of the
// next one, both from the core's side. All four are processed at once, one per lane.
using Quadrants = std::array<float, 4>;

Pack4f of_next(Pack4f a) noexcept { return Pack4f{a[1], a[2], a[3], a[0]}; }
Pack4f of_opposite(Pack4f a) noexcept { return Pack4f{a[2], a[3], a[0], a[1]}; }

// How far a corner of the box can reach. Each step is a limit on `ahead` up to a value of `aside`.
// From the ahead axis to the aside axis, `ahead` falls and `aside` rises; none is negative.
struct Staircase {
  std::array<float, 2 * kCapacity + 1> ahead;  // NOLINT(*-member-init): filled as far as it is read
  std::array<float, 2 * kCapacity + 1> aside;  // NOLINT(*-member-init)
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct Range {
  std::size_t least;
  std::size_t most;
};

// The turned axes cut each of the points' quadrants in two: the least and the greatest step of the
// cut.
Range where_cut(const ObstaclePoints& points, float c, float s) noexcept {
  Range cut{.least = points.steps(), .most = 0};
  for (std::size_t q = 0; q < 4; ++q) {
    std::size_t first = 0;
    for (std::size_t size = points.steps(); size > 0;) {
      const std::size_t half = size / 2;
      const std::size_t at = 4 * (first + half) + q;
      // Before the axis. Missing points come last, are NaN and compare false.
      const bool before = c * points.aside()[at] < s * points.ahead()[at];
      first = before ? first + half + 1 : first;
      size = before ? size - half - 1 : half;
    }
    cut = {.least = std::min(cut.least, first), .most = std::max(cut.most, first)};
  }
  return cut;
}

// A corner must stay below the `ahead` of all points before its direction. It must also stay below
// the `aside` of all points behind it. The running minimum of `ahead` from one side and of `aside`
// from the other are therefore sufficient. A point straight beside the core has a negative `aside`;
// only `ahead` can avoid it. No corner can avoid a point in the core.
class Staircases {
 public:
  Staircases(const ObstaclePoints& points,
             const Vector2d& along,
             const Box& core,
             double longest_side) noexcept {
    const Pack4f reach{static_cast<float>(core.max.x()), static_cast<float>(core.max.y()),
                       static_cast<float>(-core.min.x()), static_cast<float>(-core.min.y())};
    const Pack4f reach_aside = of_next(reach);
    const Pack4f cap = static_cast<float>(longest_side) - reach - of_opposite(reach);
    Pack4f least_ahead = cap;
    const auto take = [&](Pack4f ahead, Pack4f aside, Mask4 mine) {
      // Other points do not count. Missing points do not either: comparisons with NaN fail.
      const Pack4f least = with_sign_of(mine, four(kFar));
      store4(least_ahead, &before_[4 * count_]);
      least_ahead = min(least_ahead, max(ahead - reach, least));
      store4(max(aside - reach_aside, least), &aside_[4 * count_]);
      ++count_;
    };
    // A quadrant of the turned frame contains the end of one of the points' quadrants, and then the
    // beginning of the next.
    const auto c = static_cast<float>(along.x());
    const auto s = static_cast<float>(along.y());
    const Range cut = where_cut(points, c, s);
    for (std::size_t i = cut.least; i < points.steps(); ++i) {
      const Pack4f u = load4(points.ahead() + 4 * i);
      const Pack4f v = load4(points.aside() + 4 * i);
      const Pack4f aside = c * v - s * u;
      take(c * u + s * v, aside, aside >= 0.0F);
    }
    for (std::size_t i = 0; i < cut.most; ++i) {
      const Pack4f u = of_next(load4(points.ahead() + 4 * i));
      const Pack4f v = of_next(load4(points.aside() + 4 * i));
      const Pack4f ahead = s * u - c * v;
      take(ahead, c * u + s * v, ahead > 0.0F);
    }
    store4(least_ahead, &before_[4 * count_]);
    store4(cap, cap_.data());
    store4(reach, reach_.data());
  }

  void extract(std::array<Staircase, 4>& out) const noexcept {
    // The steps at which the running minimum from behind falls, as bits.
    const std::size_t words = count_ / kBits + 1;
    std::array<std::array<std::uint32_t, 4>, 2 * kCapacity / kBits + 1>
        falls;  // NOLINT(*-member-init): filled below
    Pack4f least = of_next(load4(cap_.data()));
    for (std::size_t w = words; w-- > 0;) {
      Bits4 bits{};
      for (std::size_t i = std::min(count_, (w + 1) * kBits); i-- > w * kBits;) {
        const Pack4f aside = load4(&aside_[4 * i]);
        bits = bits + bits - std::bit_cast<Bits4>(aside < least);  // true is -1
        least = min(least, aside);
      }
      std::memcpy(falls[w].data(), &bits, sizeof bits);
    }
    for (std::size_t q = 0; q < 4; ++q) {
      Staircase& staircase = out[q];
      float ahead = cap_[q];
      std::size_t count = 0;
      for (std::size_t w = 0; w < words; ++w) {
        for (std::uint32_t left = falls[w][q]; left != 0; left &= left - 1) {
          const std::size_t i = w * kBits + static_cast<std::size_t>(std::countr_zero(left));
          staircase.ahead[count] = ahead;
          staircase.aside[count] = aside_[4 * i + q];
          // The next step reaches less far ahead; if it does not, it replaces this one.
          const float next = before_[4 * (i + 1) + q];
          count += next < ahead ? 1 : 0;
          ahead = next;
        }
      }
      staircase.ahead[count] = ahead;
      staircase.aside[count] = cap_[(q + 1) % 4];
      staircase.begin = 0;
      staircase.end = count + 1;
      while (staircase.begin < staircase.end && staircase.aside[staircase.begin] < 0.0F)
        ++staircase.begin;
      while (staircase.begin < staircase.end && staircase.ahead[staircase.end - 1] < 0.0F)
        --staircase.end;
    }
  }

 private:
  using Steps = std::array<float, 4 * (2 * kCapacity + 1)>;

  Quadrants reach_;  // extent of the core
  Quadrants cap_;    // limit on how far ahead a corner may be
  std::size_t count_ = 0;
  Steps before_;  // least `ahead` of the preceding steps
  Steps aside_;   // NOLINT(*-member-init)
};

// The heights at which the top (or bottom) side can stop, measured outwards. For each, the extent
// of the box to both sides, considering only the points on this half.
struct Levels {
  static constexpr std::size_t kMost = 2 * (2 * kCapacity + 1);
  alignas(16) std::array<float, kMost + 4> height;   // NOLINT(*-member-init): filled by merge
  alignas(16) std::array<float, kMost + 4> rising;   // NOLINT(*-member-init)
  alignas(16) std::array<float, kMost + 4> falling;  // NOLINT(*-member-init)
  std::size_t count = 0;

  // Merges the staircase of a quadrant with that of the next one. The heights of the first are its
  // `aside`, those of the second its `ahead`. The result is padded to whole lanes with levels of no
  // area.
  void merge(const Staircase& rising_side, const Staircase& falling_side) noexcept {
    std::size_t i = rising_side.begin;
    std::size_t j = falling_side.end;
    count = 0;
    while (i < rising_side.end && j > falling_side.begin) {
      const float a = rising_side.aside[i];
      const float b = falling_side.ahead[j - 1];
      height[count] = std::min(a, b);
      rising[count] = rising_side.ahead[i];
      falling[count] = falling_side.aside[j - 1];
      ++count;
      i += a <= b ? 1 : 0;
      j -= b <= a ? 1 : 0;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      height[count + k] = -kFar;
      rising[count + k] = falling[count + k] = 0.0F;
    }
  }
};

struct Pair {
  std::size_t top = 0;
  std::size_t bottom = 0;
  float area = 0.0F;
};

// Returns the pair of a top and a bottom level with the greatest area. The inner loop has no
// branch: there are few levels, and skipping some costs more than it saves.
Pair best_pair(const Levels& tops, const Levels& bottoms, const Box& core, float limit) noexcept {
  const auto core_width = static_cast<float>(core.max.x() - core.min.x());
  const auto core_height = static_cast<float>(core.max.y() - core.min.y());
  const auto area = [&](std::size_t top, std::size_t bottom) {
    // The rising side of a top level is the right one, that of a bottom level the left one.
    const Pack4f width = min(four(tops.rising[top]), load4(&bottoms.falling[bottom])) +
                         min(four(tops.falling[top]), load4(&bottoms.rising[bottom]));
    const Pack4f height = tops.height[top] + load4(&bottoms.height[bottom]);
    return min(width + core_width, four(limit)) * min(height + core_height, four(limit));
  };
  Pair best;
  for (std::size_t top = 0; top < tops.count; ++top) {
    Pack4f greatest = four(-1.0F);
    for (std::size_t bottom = 0; bottom < bottoms.count; bottom += 4)
      greatest = max(greatest, area(top, bottom));
    const float row =
        std::max(std::max(greatest[0], greatest[1]), std::max(greatest[2], greatest[3]));
    best.top = row > best.area ? top : best.top;
    best.area = std::max(row, best.area);
  }
  for (std::size_t bottom = 0; bottom < bottoms.count; bottom += 4) {
    const Pack4f areas = area(best.top, bottom);
    for (std::size_t k = 0; k < 4; ++k) {
      if (areas[k] == best.area) return {.top = best.top, .bottom = bottom + k, .area = best.area};
    }
  }
  return best;
}

// Trims [low, high] to at most `limit`, as centrally about [core_low, core_high] as possible.
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
                               double longest_side,
                               double least_area) noexcept {
  FAIRWAY_EXPECTS(along.x() >= 0.0 && along.y() >= 0.0);
  std::array<Staircase, 4> quadrants;
  const Staircases staircases(points, along, core, longest_side);
  staircases.extract(quadrants);
  Levels tops;
  Levels bottoms;
  tops.merge(quadrants[0], quadrants[1]);
  bottoms.merge(quadrants[2], quadrants[3]);
  if (tops.count == 0 || bottoms.count == 0) return std::nullopt;
  const Pair best = best_pair(tops, bottoms, core, static_cast<float>(longest_side));
  if (!(best.area > static_cast<float>(least_area))) return std::nullopt;
  const float right = std::min(tops.rising[best.top], bottoms.falling[best.bottom]);
  const float left = std::min(tops.falling[best.top], bottoms.rising[best.bottom]);
  Box box{.min = core.min - Vector2d(left, bottoms.height[best.bottom]),
          .max = core.max + Vector2d(right, tops.height[best.top])};
  trim(box.min.x(), box.max.x(), core.min.x(), core.max.x(), longest_side);
  trim(box.min.y(), box.max.y(), core.min.y(), core.max.y(), longest_side);
  return box;
}

}  // namespace fairway
