// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/straightening.hpp"

#include <array>
#include <cmath>

namespace fairway {

namespace {

using Eigen::Vector2d;

// All lengths are in cells. Costs within kRounding count as equal. A move must gain at least
// kLeastGain, an additional corner kWorthACorner. Corners end within about kLastStep of their best
// position.
constexpr double kRounding = 1e-6;
constexpr double kLeastGain = 0.01;
constexpr double kWorthACorner = 0.2;
constexpr double kFirstStep = 2.0;
constexpr double kLastStep = 0.4;
constexpr int kSweeps = 6;  // sweeps of moves, before and after each round of cuts
constexpr int kCuts = 2;

bool fits(const TravelCost& costs,
          const TravelCost::Line& line,
          const Vector2d& a,
          const Vector2d& b) {
  return line.surely_free || costs.fits(a, b);
}

}  // namespace

void Straightening::apply(const TravelCost& costs, std::vector<Vector2d>& points) {
  if (points.size() < 3) return;
  connect_lines_of_sight(costs, points);
  for (int cut = 0; cut <= kCuts; ++cut) {
    for (int sweep = 0; sweep < kSweeps && move_corners(costs); ++sweep) {
    }
    if (cut == kCuts || !cut_corners(costs)) break;
  }
  points.clear();
  for (const Corner& corner : corners_)
    points.push_back(corner.point);
}

// Connects each corner to the furthest point that a line may lead to. Visibility is not monotone
// along the chain; doubling the reach and then bisecting finds a far point in few tests.
void Straightening::connect_lines_of_sight(const TravelCost& costs,
                                           const std::vector<Vector2d>& points) {
  const std::size_t n = points.size();
  cost_to_.assign(n, 0.0);
  for (std::size_t i = 1; i < n; ++i)
    cost_to_[i] = cost_to_[i - 1] + costs.fitting_line(points[i - 1], points[i]).cost;
  corners_.clear();
  corners_.push_back({.point = points.front()});
  for (std::size_t i = 0; i + 1 < n;) {
    double cost = cost_to_[i + 1] - cost_to_[i];
    const auto may_lead_to = [&](std::size_t j) {
      const TravelCost::Line line =
          costs.fitting_line(points[i], points[j], cost_to_[j] - cost_to_[i] + kRounding);
      if (std::isinf(line.cost) || !fits(costs, line, points[i], points[j])) return false;
      cost = line.cost;
      return true;
    };
    std::size_t good = i + 1;
    std::size_t bad = n;
    for (std::size_t reach = 2; bad == n && good + 1 < n; reach *= 2) {
      const std::size_t j = std::min(i + reach, n - 1);
      (may_lead_to(j) ? good : bad) = j;
    }
    while (good + 1 < bad) {
      const std::size_t j = good + (bad - good) / 2;
      (may_lead_to(j) ? good : bad) = j;
    }
    corners_.push_back({.point = points[good], .cost = cost, .step = kFirstStep});
    i = good;
  }
}

// Makes one sweep: drops each corner that a line may replace, and tries to move the others by their
// step. Returns false when no step is left to try.
bool Straightening::move_corners(const TravelCost& costs) {
  bool busy = false;
  std::size_t kept = 1;
  for (std::size_t i = 1; i + 1 < corners_.size(); ++i) {
    const Corner& before = corners_[kept - 1];
    Corner& corner = corners_[i];
    Corner& after = corners_[i + 1];
    if (corner.step >= kLastStep) {
      busy = true;
      const TravelCost::Line direct =
          costs.fitting_line(before.point, after.point, corner.cost + after.cost + kRounding);
      if (!std::isinf(direct.cost) && fits(costs, direct, before.point, after.point)) {
        after.cost = direct.cost;
        after.step = std::max(after.step, kFirstStep);
        continue;
      }
      if (!move_corner(costs, before.point, corner, after)) corner.step *= 0.5;
    }
    corners_[kept++] = corner;
  }
  corners_[kept++] = corners_.back();
  corners_.resize(kept);
  return busy;
}

// Moves a corner to the cheapest of four positions around it: inward along its bisector, outward,
// or to either side.
bool Straightening::move_corner(const TravelCost& costs,
                                const Vector2d& before,
                                Corner& corner,
                                Corner& after) {
  const Vector2d from = corner.point;
  Vector2d inward = (before - from).stableNormalized() + (after.point - from).stableNormalized();
  if (inward.squaredNorm() < 1e-12) return false;
  inward *= corner.step / inward.norm();
  const Vector2d along(-inward.y(), inward.x());
  bool moved = false;
  for (const Vector2d& offset : {inward, along, Vector2d(-along), Vector2d(-inward)}) {
    const Vector2d to = from + offset;
    const double limit = corner.cost + after.cost - kLeastGain;
    // No metre costs less than 1, so the second line costs at least its length.
    const TravelCost::Line first =
        costs.fitting_line(before, to, limit - (after.point - to).norm());
    if (std::isinf(first.cost)) continue;
    const TravelCost::Line second = costs.fitting_line(to, after.point, limit - first.cost);
    if (std::isinf(second.cost) || !fits(costs, first, before, to) ||
        !fits(costs, second, to, after.point)) {
      continue;
    }
    corner.point = to;
    corner.cost = first.cost;
    after.cost = second.cost;
    moved = true;
  }
  return moved;
}

// Replaces a corner by two, one on each leg, where that reduces the cost. A sharp turn around an
// obstacle needs more than one corner.
bool Straightening::cut_corners(const TravelCost& costs) {
  bool changed = false;
  cut_.clear();
  cut_.push_back(corners_.front());
  for (std::size_t i = 1; i < corners_.size(); ++i) {
    Corner corner = corners_[i];
    if (i + 1 == corners_.size()) {
      cut_.push_back(corner);
      break;
    }
    const Vector2d before = cut_.back().point;
    Corner& after = corners_[i + 1];
    const Vector2d to_before = before - corner.point;
    const Vector2d to_after = after.point - corner.point;
    const double leg = std::min(to_before.norm(), to_after.norm());
    bool cut = false;
    for (double size = 0.5 * leg; size > 0.5 && !cut; size *= 0.5) {
      const Vector2d p = corner.point + size * to_before.normalized();
      const Vector2d q = corner.point + size * to_after.normalized();
      // This is the greatest possible gain where all metres cost the same; smaller cuts gain less.
      if ((2.0 * size - (q - p).norm()) * static_cast<double>(costs.greatest_cost()) <
          kWorthACorner)
        break;
      const TravelCost::Line first = costs.fitting_line(before, p);
      const TravelCost::Line last = costs.fitting_line(q, after.point);
      const double limit = corner.cost + after.cost - kWorthACorner - first.cost - last.cost;
      const TravelCost::Line middle = costs.fitting_line(p, q, limit);
      if (std::isinf(middle.cost) || !fits(costs, middle, p, q)) continue;
      // The parts of the legs lie on pieces that fit, up to rounding; check them again.
      if (!fits(costs, first, before, p) || !fits(costs, last, q, after.point)) continue;
      cut_.push_back({.point = p, .cost = first.cost, .step = kFirstStep});
      corner = {.point = q, .cost = middle.cost, .step = kFirstStep};
      after.cost = last.cost;
      cut = true;
    }
    changed = changed || cut;
    cut_.push_back(corner);
  }
  corners_.swap(cut_);
  return changed;
}

}  // namespace fairway
