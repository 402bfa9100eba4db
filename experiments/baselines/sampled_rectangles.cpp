// SPDX-License-Identifier: Apache-2.0
#include "experiments/baselines/sampled_rectangles.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace fairway::baselines {

namespace {

using Eigen::Vector2d;

class Sampler {
 public:
  Sampler(const BitGrid& obstacles, const Vector2d& seed, double orientation, Sampling sampling)
      : obstacles_(obstacles),
        seed_(obstacles.frame().to_grid(seed)),
        along_(direction(orientation - obstacles.frame().origin.heading) /
               obstacles.frame().resolution),
        spacing_((sampling == Sampling::Edge ? 1.0 : 0.5) * obstacles.frame().resolution) {}

  [[nodiscard]] bool free(double x, double y) const { return free(at(x, y)); }

  // All samples of the rectangle from (x0, y0) to (x1, y1), borders included.
  [[nodiscard]] bool free(double x0, double y0, double x1, double y1) const {
    const int nx = static_cast<int>(std::ceil((x1 - x0) / spacing_));
    const int ny = static_cast<int>(std::ceil((y1 - y0) / spacing_));
    const Vector2d step = nx == 0 ? Vector2d(0, 0) : Vector2d(along_ * ((x1 - x0) / nx));
    for (int j = 0; j <= ny; ++j) {
      Vector2d p = at(x0, ny == 0 ? y0 : y0 + (y1 - y0) * j / ny);
      for (int i = 0; i <= nx; ++i, p += step) {
        if (!free(p)) return false;
      }
    }
    return true;
  }

 private:
  [[nodiscard]] Vector2d at(double x, double y) const {
    return seed_ + Vector2d(along_.x() * x - along_.y() * y, along_.y() * x + along_.x() * y);
  }
  [[nodiscard]] bool free(const Vector2d& p) const {
    // std::floor is a function call unless the compiler may use the processor's instruction.
    constexpr int kBias = 65536;
    const auto cell = [](double v) { return static_cast<int>(v + kBias) - kBias; };
    return !obstacles_.blocked({.x = cell(p.x()), .y = cell(p.y())});
  }

  const BitGrid& obstacles_;
  Vector2d seed_;
  Vector2d along_;
  double spacing_;
};

// Sides in the order up, left, down, right, as distances from the seed.
using Extents = std::array<double, 4>;

bool gained_is_free(
    const Sampler& sampler, const Extents& at, std::size_t side, double from, Sampling sampling) {
  const double start = sampling == Sampling::Edge ? at[side] : from;
  switch (side) {
    case 0:
      return sampler.free(-at[1], start, at[3], at[0]);
    case 1:
      return sampler.free(-at[1], -at[2], -start, at[0]);
    case 2:
      return sampler.free(-at[1], -at[2], at[3], -start);
    default:
      return sampler.free(start, -at[2], at[3], at[0]);
  }
}

Extents grow(const Sampler& sampler, const SampledGrowth& settings) {
  Extents at{};
  std::array<bool, 4> growing{true, true, true, true};
  while (growing[0] || growing[1] || growing[2] || growing[3]) {
    for (std::size_t side = 0; side < 4; ++side) {
      if (!growing[side]) continue;
      const double from = at[side];
      at[side] += settings.growth_step;
      growing[side] = at[side] <= settings.max_growth &&
                      gained_is_free(sampler, at, side, from, settings.sampling);
      if (!growing[side]) at[side] = from;
    }
  }
  return at;
}

}  // namespace

std::optional<OrientedRectangle> grow_sampled(const BitGrid& obstacles,
                                              const Vector2d& seed,
                                              const SampledGrowth& settings) {
  std::optional<OrientedRectangle> best;
  for (int k = 0; k < settings.num_orientations; ++k) {
    const double orientation = std::numbers::pi / 2.0 * k / settings.num_orientations;
    const Sampler sampler(obstacles, seed, orientation, settings.sampling);
    if (!sampler.free(0.0, 0.0)) return std::nullopt;
    const Extents at = grow(sampler, settings);
    const OrientedRectangle rectangle{.seed = seed,
                                      .orientation = orientation,
                                      .min = Vector2d(-at[1], -at[2]),
                                      .max = Vector2d(at[3], at[0])};
    if (!best || rectangle.area() > best->area()) best = rectangle;
  }
  return best;
}

std::vector<OrientedRectangle> build_sampled(const BitGrid& obstacles,
                                             const Path& path,
                                             const SampledGrowth& settings) {
  std::vector<OrientedRectangle> corridor;
  const auto append = [&](std::size_t i) {
    if (const auto r = grow_sampled(obstacles, path.waypoints[i], settings)) corridor.push_back(*r);
  };
  if (path.waypoints.empty()) return corridor;
  append(0);
  for (std::size_t i = 1; i < path.waypoints.size() && !corridor.empty(); ++i) {
    if (!corridor.back().contains(path.waypoints[i])) {
      append(i - 1);
      if (!corridor.back().contains(path.waypoints[i])) append(i);
    }
  }
  append(path.waypoints.size() - 1);
  return corridor;
}

}  // namespace fairway::baselines
