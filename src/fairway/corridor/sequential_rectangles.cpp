// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/sequential_rectangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fairway/corridor/path_track.hpp"
#include "fairway/corridor/rectangle/largest_rectangle.hpp"
#include "fairway/corridor/rectangle/rectangle_growth.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

struct SeedPoint {
  Vector2d point;
  double along;  // arc length along the path [m]
};

// Returns points at most `spacing` apart, corners included. On a straight piece, no point but its
// end is further than the map's diagonal: beyond that the piece has left the map.
std::vector<SeedPoint> seed_points(const Path& path, double spacing, const GridFrame& map) {
  const double longest = map.resolution * std::hypot(map.width, map.height);
  std::vector<SeedPoint> seeds{{path.waypoints.front(), 0.0}};
  for (std::size_t i = 1; i < path.waypoints.size(); ++i) {
    const Vector2d from = path.waypoints[i - 1];
    const Vector2d line = path.waypoints[i] - from;
    const double length = line_length(line);
    if (length == 0.0) continue;
    const double start = seeds.back().along;
    const double pieces = std::ceil(length / spacing);
    const int inner = static_cast<int>(std::min(pieces - 1.0, std::ceil(longest / spacing)));
    for (int k = 1; k <= inner; ++k) {
      const double share = k / pieces;
      seeds.push_back({from + share * line, start + share * length});
    }
    seeds.push_back({path.waypoints[i], start + length});
  }
  return seeds;
}

class Chain {
 public:
  Chain(const BitGrid& obstacles,
        double clearance,
        const CorridorSettings& settings,
        std::vector<SeedPoint> seeds,
        const GrowRectangle& grow,
        Corridor& corridor)
      : obstacles_(obstacles),
        clearance_(clearance),
        longest_side_(2.0 * settings.max_growth),
        min_overlap_(settings.min_overlap_area),
        seeds_(std::move(seeds)),
        grow_(grow),
        corridor_(corridor) {}

  // @return Built, or why it stopped at seeds()[reached()].
  CorridorStatus run() {
    if (!add(grow(0), 0)) return CorridorStatus::SeedBlocked;
    while (reached_ + 1 < seeds_.size()) {
      const CorridorStatus status = extend();
      if (status != CorridorStatus::Built) return status;
    }
    return CorridorStatus::Built;
  }

  [[nodiscard]] double reached() const noexcept { return seeds_[reached_].along; }

 private:
  [[nodiscard]] std::optional<OrientedRectangle> grow(std::size_t seed) const {
    return grow_(seeds_[seed].point);
  }

  [[nodiscard]] bool holds(const OrientedRectangle& rectangle, std::size_t seed) const noexcept {
    return rectangle.contains(seeds_[seed].point, kRounding - corridor_.inward_offset);
  }

  // Appends a rectangle if it contains point `next`. Unless it is the first, it must also contain
  // the point before and overlap the chain sufficiently.
  bool add(const std::optional<OrientedRectangle>& rectangle, std::size_t next) {
    if (!rectangle || !holds(*rectangle, next)) return false;
    std::size_t from = next;
    if (!corridor_.rectangles.empty()) {
      if (!holds(*rectangle, reached_)) return false;
      const OverlapPatch patch = overlap(corridor_.admissible(corridor_.rectangles.size() - 1),
                                         rectangle->shrunk(corridor_.inward_offset));
      if (patch.count == 0 || patch.area() < min_overlap_) return false;
      while (from > first_ && holds(*rectangle, from - 1))
        --from;
    }
    first_ = from;
    reached_ = next;
    while (reached_ + 1 < seeds_.size() && holds(*rectangle, reached_ + 1))
      ++reached_;
    corridor_.rectangles.push_back(*rectangle);
    corridor_.spans.push_back({.from = seeds_[from].along, .to = seeds_[reached_].along});
    return true;
  }

  // Adds one more rectangle that contains the point after the last one reached.
  CorridorStatus extend() {
    constexpr std::size_t kTries = 40;
    const std::size_t last = reached_;
    const std::size_t next = last + 1;
    const std::size_t first = std::max(first_, last - std::min(last, kTries));
    bool possible = false;
    const auto try_seed = [&](std::size_t seed) {
      const auto rectangle = grow(seed);
      possible = possible || (rectangle && holds(*rectangle, next));
      return add(rectangle, next);
    };
    if (try_seed(last) || try_seed(next)) return CorridorStatus::Built;
    for (std::size_t seed = last; seed-- > first;) {
      if (try_seed(seed)) return CorridorStatus::Built;
    }
    const double margin = corridor_.inward_offset;
    for (std::size_t back = last + 1; back-- > first;) {
      const std::array<Anchor, 2> others{Anchor{seeds_[last].point, margin},
                                         Anchor{seeds_[next].point, margin}};
      const auto rectangle = largest_rectangle(obstacles_, clearance_, {seeds_[back].point, margin},
                                               others, {.longest_side = longest_side_});
      if (!rectangle) break;
      possible = true;
      if (add(rectangle, next)) return CorridorStatus::Built;
    }
    return possible ? CorridorStatus::NoOverlap : CorridorStatus::SeedBlocked;
  }

  // Tolerance for a seed on the contracted border of its rectangle [m].
  static constexpr double kRounding = 1e-9;

  const BitGrid& obstacles_;
  double clearance_;
  double longest_side_;
  double min_overlap_;
  std::vector<SeedPoint> seeds_;
  const GrowRectangle& grow_;
  Corridor& corridor_;
  std::size_t first_ = 0;    // first point that the last rectangle contains
  std::size_t reached_ = 0;  // last point that it contains without a gap
};

}  // namespace

CorridorResult build_sequential(const BitGrid& obstacles,
                                const Path& path,
                                double robot_radius,
                                const CorridorSettings& settings) {
  const bool workspace = settings.space == CorridorSpace::Workspace;
  const GrowthSettings growth{.num_orientations = settings.num_orientations,
                              .growth_step = settings.growth_step,
                              .max_growth = settings.max_growth,
                              .start_size = workspace ? settings.inward_offset : 0.0};
  return build_sequential(obstacles, path, robot_radius, settings, [&](const Vector2d& seed) {
    return grow_rectangle(obstacles, workspace ? 0.0 : robot_radius, seed, growth);
  });
}

CorridorResult build_sequential(const BitGrid& obstacles,
                                const Path& path,
                                double robot_radius,
                                const CorridorSettings& settings,
                                const GrowRectangle& grow) {
  CorridorResult result;
  const bool workspace = settings.space == CorridorSpace::Workspace;
  result.corridor.space = settings.space;
  result.corridor.robot_radius = robot_radius;
  result.corridor.inward_offset = workspace ? settings.inward_offset : 0.0;
  const bool usable = !path.waypoints.empty() &&
                      std::all_of(path.waypoints.begin(), path.waypoints.end(),
                                  [](const Vector2d& p) { return is_finite(p); }) &&
                      std::isfinite(path.length());
  if (!usable) return result;
  Chain chain(obstacles, workspace ? 0.0 : robot_radius, settings,
              seed_points(path, settings.waypoint_spacing, obstacles.frame()), grow,
              result.corridor);
  result.status = chain.run();
  if (result.status == CorridorStatus::Built) return result;
  result.stuck_at = chain.reached();
  result.stuck_waypoint = waypoint_before(path, result.stuck_at);
  return result;
}

}  // namespace fairway
