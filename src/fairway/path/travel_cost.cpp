// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/travel_cost.hpp"

#include <cmath>

#include "fairway/base/contract.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/zones/zone_map.hpp"

namespace fairway {

namespace {

// Obstacles that can come closer to the line between the centres of two diagonal neighbours than to
// the centres themselves.
//
// From (1/2, 1/2) to (3/2, 3/2) the squared distance to a cell with the corner (1 + k, 1 - k) is 2
// k^2 + 1/2 at both ends and 2 k^2 in the middle; for every other cell it is least at an end. With
// R the required distance in cells, only k with 2 k^2 < R^2 <= 2 k^2 + 1/2 matter: the largest k
// below R / sqrt 2, and none for most R. k = 0 is the rule not to cut corners.
int critical_corner(double required_low, double required_high) {
  const int k = static_cast<int>(std::min(1e6, required_high / std::sqrt(2.0)));
  return required_low * required_low > 2.0 * k * k + 0.5 ? -1 : k;
}

}  // namespace

TravelCost::TravelCost(const BitGrid& obstacles,
                       const DistanceField& distances,
                       double required,
                       const PathSettings& settings)
    : obstacles_(obstacles),
      distances_(distances),
      required_(required) {
  FAIRWAY_EXPECTS(required >= 0.0);
  const GridFrame& frame = obstacles.frame();
  FAIRWAY_EXPECTS(distances.frame().width == frame.width &&
                  distances.frame().height == frame.height);
  // Twice the skin of is_free plus the rounding of the field, so that is_free holds in every
  // allowed cell.
  const double allowed = (required + 2.0 * kFreeSpaceSkin) * (1.0 + 3e-7);
  allowed_ = static_cast<float>(allowed);
  surely_free_distance_ = static_cast<float>(allowed + frame.resolution * std::sqrt(0.5));
  // No point of a cell is further from its centre than half a diagonal; a little less for rounding.
  surely_blocked_distance_ =
      static_cast<float>(required * (1.0 - 1e-6) - frame.resolution * std::sqrt(0.5));
  corner_ = critical_corner(required / frame.resolution, allowed / frame.resolution);
  const bool graded = settings.comfort_distance > 0.0 && settings.comfort_weight > 0.0;
  const double rise = graded ? settings.comfort_weight / settings.comfort_distance : 0.0;
  rise_ = static_cast<float>(rise);
  at_zero_ = static_cast<float>(1.0 + rise * (allowed + settings.comfort_distance));
  greatest_cost_ = graded ? static_cast<float>(1.0 + settings.comfort_weight) : 1.0F;
  greatest_at_distance_ = greatest_cost_;
  cells_per_metre_ = 1.0 / frame.resolution;
  // Beyond this distance a metre costs 1 and the robot surely fits; a little more for the rounding.
  const float costs_nothing = graded ? (at_zero_ - 1.0F) / rise_ * (1.0F + 1e-5F) : 0.0F;
  easy_distance_ = std::max(surely_free_distance_, costs_nothing);
  const ZoneMap* zones = obstacles.zones();
  if (zones == nullptr) return;
  // Zones are known within their reach only, so distances may differ by more than those of cells.
  easy_distance_ = std::numeric_limits<float>::infinity();
  surely_blocked_distance_ = -1.0F;
  steps_need_checks_ = zones->forbids() || zones->has_costs();
  if (!zones->has_costs()) return;
  zone_costs_ = zones;
  greatest_cost_ += static_cast<float>(zones->greatest_cost());
}

float TravelCost::zone_cost(CellIndex cell) const noexcept {
  return static_cast<float>(zone_costs_->cost_at(frame().center(cell)));
}

bool TravelCost::goes_against_zone(const Eigen::Vector2d& a,
                                   const Eigen::Vector2d& b) const noexcept {
  return zone_costs_ != nullptr &&
         zone_costs_->against({.a = frame().to_world(a), .b = frame().to_world(b)}).has_value();
}

bool TravelCost::step_fits(CellIndex from, CellIndex to) const noexcept {
  const ZoneMap* zones = obstacles_.zones();
  const Eigen::Vector2d a = frame().center(from);
  const Eigen::Vector2d b = frame().center(to);
  if (zone_costs_ != nullptr && zones->against({.a = a, .b = b})) return false;
  const double far = static_cast<double>(surely_free_distance_) + frame().resolution;
  if (far < zones->reach() && distances_.at(from) >= far && distances_.at(to) >= far) return true;
  return !zones->forbidding(segment_rectangle(a, b), required_ + kFreeSpaceSkin, ZoneSubject::Disc);
}

TravelCost::Line TravelCost::line(const Eigen::Vector2d& a,
                                  const Eigen::Vector2d& b,
                                  double limit) const noexcept {
  return line_above(-1.0F, a, b, limit);
}

TravelCost::Line TravelCost::fitting_line(const Eigen::Vector2d& a,
                                          const Eigen::Vector2d& b,
                                          double limit) const noexcept {
  return line_above(surely_blocked_distance_, a, b, limit);
}

TravelCost::Line TravelCost::line_above(float floor,
                                        const Eigen::Vector2d& a,
                                        const Eigen::Vector2d& b,
                                        double limit) const noexcept {
  if (zone_costs_ == nullptr) return line_by_distance(floor, a, b, limit);
  const double extra =
      zone_costs_->cost_along({.a = frame().to_world(a), .b = frame().to_world(b)}) /
      frame().resolution;
  Line line = line_by_distance(floor, a, b, limit - extra);
  line.cost += extra;
  line.surely_free = line.surely_free && !goes_against_zone(a, b);
  return line;
}

TravelCost::Line TravelCost::line_by_distance(float floor,
                                              const Eigen::Vector2d& a,
                                              const Eigen::Vector2d& b,
                                              double limit) const noexcept {
  const GridFrame& grid = frame();
  const auto inside = [&](const Eigen::Vector2d& p) {
    return p.x() >= 0.0 && p.x() < grid.width && p.y() >= 0.0 && p.y() < grid.height;
  };
  if (!inside(a) || !inside(b)) return {};
  constexpr double kFar = std::numeric_limits<double>::max();
  const float* const cells = distances_.cells().data();
  // Follows the longer axis u, one column of cells at a time. In each column the line meets one
  // cell, or two neighbours across, along v. The loop has no branches that depend on the line,
  // because they would be mispredicted.
  const bool steep = std::abs(b.y() - a.y()) > std::abs(b.x() - a.x());
  const int u_axis = steep ? 1 : 0;
  const std::ptrdiff_t u_stride = steep ? grid.width : 1;
  const std::ptrdiff_t v_stride = steep ? 1 : grid.width;
  const Eigen::Vector2d& from = a[u_axis] <= b[u_axis] ? a : b;
  const Eigen::Vector2d& to = a[u_axis] <= b[u_axis] ? b : a;
  const double u0 = from[u_axis];
  const double u1 = to[u_axis];
  const double v0 = from[1 - u_axis];
  const double v1 = to[1 - u_axis];
  const double length = (b - a).norm();
  if (length == 0.0) return {.cost = 0.0, .surely_free = false};
  if (length > limit) return {};  // no cell costs less than 1
  const double slope = (v1 - v0) / (u1 - u0);
  const int v_last = static_cast<int>(v1);
  const double per_slope = slope != 0.0 ? 1.0 / std::abs(slope) : kFar;
  const double scale = length / (u1 - u0);  // of the line's length to its extent along u
  const double per_extent = (u1 - u0) / length;
  const double bound = limit * per_extent;
  double sum = 0.0;
  float least = std::numeric_limits<float>::infinity();
  double u = u0;
  double v = v0;
  int v_cell = static_cast<int>(v0);
  const int u_last = static_cast<int>(u1);
  for (int u_cell = static_cast<int>(u0); u_cell <= u_last; ++u_cell) {
    const float d0 = cells[u_cell * u_stride + v_cell * v_stride];
    // Skips columns of which all cells near the line are easy. Their centres are within 1 /
    // per_extent per column of this one's, and both are within a cell of the line.
    if (d0 > easy_distance_) {
      constexpr double kAcross = 2.01;  // [cells]
      const double far =
          (static_cast<double>(d0 - easy_distance_) * cells_per_metre_ - kAcross) * per_extent;
      if (far >= 1.0) {
        const int columns = 1 + static_cast<int>(far);
        const double u_next = std::min(static_cast<double>(u_cell + columns), u1);
        sum += u_next - u;
        least = std::min(least, easy_distance_);
        if (sum + (u1 - u_next) > bound) return {};
        u = u_next;
        v = v0 + (u - u0) * slope;
        v_cell = static_cast<int>(v);
        v_cell = slope >= 0.0 ? std::min(v_cell, v_last) : std::max(v_cell, v_last);
        u_cell += columns - 1;
        continue;
      }
    }
    const double u_next = std::min(u_cell + 1.0, u1);
    const double v_next = v0 + (u_next - u0) * slope;
    int next_cell = static_cast<int>(v_next);
    next_cell = slope >= 0.0 ? std::min(next_cell, v_last) : std::max(next_cell, v_last);
    // Distance along u for which the line stays in the first of the two cells.
    const double rest = slope >= 0.0 ? v_cell + 1.0 - v : v - v_cell;
    const double width = u_next - u;
    const double in_first = next_cell == v_cell ? width : std::min(rest * per_slope, width);
    const float* column = cells + u_cell * u_stride;
    const float d1 = column[next_cell * v_stride];
    sum += in_first * static_cast<double>(at_distance(d0)) +
           (width - in_first) * static_cast<double>(at_distance(d1));
    least = std::min(least, std::min(d0, d1));
    if (sum + (u1 - u_next) > bound || least < floor) return {};
    u = u_next;
    v = v_next;
    v_cell = next_cell;
  }
  return {.cost = sum * scale, .surely_free = least >= surely_free_distance_};
}

bool TravelCost::fits(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const noexcept {
  return is_free(obstacles_, frame().to_world(a), frame().to_world(b), required_) &&
         !goes_against_zone(a, b);
}

}  // namespace fairway
