// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/rectangle/largest_rectangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "fairway/base/contract.hpp"
#include "fairway/corridor/rectangle/largest_box.hpp"
#include "fairway/corridor/rectangle/zone_points.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kQuarterTurn = std::numbers::pi / 2.0;
constexpr double kInset = 1e-3;  // distance from the obstacle points that stopped a side [cells]
// Marks an angle with nothing left to gain.
constexpr double kDone = -std::numeric_limits<double>::infinity();
// After this many failed tests an angle keeps its best result so far.
constexpr int kTestsPerAngle = 8;
constexpr int kTestsInAll = 64;
constexpr std::size_t kMaxFound = 8;  // blocked cells examined per test

Box inset(const Box& box, const Box& core) noexcept {
  const Vector2d by = Vector2d::Constant(kInset);
  return {.min = (box.min + by).cwiseMin(core.min), .max = (box.max - by).cwiseMax(core.max)};
}

}  // namespace

void RectangleSearch::evaluate(Candidate& candidate) noexcept {
  const std::optional<Box> box =
      largest_box(points_, candidate.along, candidate.core, longest_, worthwhile());
  candidate.box = box ? inset(*box, candidate.core) : Box{};
  candidate.bound = box ? box->area() : kDone;
  candidate.known = points_.size();
}

// Returns whether the bound is still valid: none of the points added since lies in the box.
bool RectangleSearch::is_up_to_date(Candidate& candidate) const noexcept {
  const TurnedFrame frame{.along = candidate.along};
  for (; candidate.known < points_.size(); ++candidate.known) {
    const Vector2d point(static_cast<double>(points_.x()[candidate.known]),
                         static_cast<double>(points_.y()[candidate.known]));
    if (candidate.box.contains(frame.turned(point))) return false;
  }
  return true;
}

void RectangleSearch::try_angle(double angle) noexcept {
  if (num_candidates_ == kMaxCandidates) return;
  Candidate& candidate = candidates_[num_candidates_];
  candidate.angle = angle - kQuarterTurn * std::floor(angle / kQuarterTurn);
  candidate.along = direction(candidate.angle).cwiseMax(0.0);  // cos(pi / 2) may be below 0
  candidate.core = {};
  candidate.tests = 0;
  const TurnedFrame frame{.origin = origin_, .along = candidate.along};
  for (const Anchor& anchor : anchors_) {
    const Vector2d p = frame.turned(anchor.point - origin_);
    const Vector2d margin = Vector2d::Constant(anchor.margin);
    candidate.core.min = candidate.core.min.cwiseMin(p - margin);
    candidate.core.max = candidate.core.max.cwiseMax(p + margin);
  }
  if ((candidate.core.max - candidate.core.min).maxCoeff() > longest_) return;
  evaluate(candidate);
  if (candidate.bound >= 0.0) ++num_candidates_;
}

bool RectangleSearch::accept_if_free(const BitGrid& obstacles,
                                     const Candidate& candidate,
                                     const Box& box) noexcept {
  if (box.area() < best_area_) return false;
  const TurnedFrame frame{.origin = origin_, .along = candidate.along};
  if (!is_free(obstacles, frame.region(box), radius_)) return false;
  best_area_ = box.area();
  best_angle_ = candidate.angle;
  best_ = {.frame = frame, .box = box};
  return true;
}

void RectangleSearch::learn(const BoxRepair& repair,
                            const Box& box,
                            std::span<const CellIndex> cells) noexcept {
  // Neighbouring cells give nearly the same points: use only cells that are well apart.
  constexpr int kApart = 3;  // [cells]
  std::array<CellIndex, kMaxFound> taken;
  std::size_t count = 0;
  for (const CellIndex& cell : cells) {
    const auto near = [&](const CellIndex& other) {
      return std::abs(cell.x - other.x) < kApart && std::abs(cell.y - other.y) < kApart;
    };
    if (std::any_of(taken.begin(), taken.begin() + static_cast<std::ptrdiff_t>(count), near))
      continue;
    taken[count++] = cell;
    for (const Eigen::Vector2d& point : repair.points_inside(cell, box))
      points_.add(point);
  }
}

void RectangleSearch::test(const BitGrid& obstacles, Candidate& candidate) noexcept {
  ++tests_;
  ++candidate.tests;
  const TurnedFrame frame{.origin = origin_, .along = candidate.along};
  const BoxRepair repair{.grid = *grid_, .frame = frame, .core = candidate.core, .radius = radius_};
  std::array<CellIndex, kMaxFound> found;
  const BlockedCells blocked =
      find_blocked_cells(obstacles, frame.region(candidate.box), radius_, origin_, found);
  if (blocked.count == 0 && !blocked.outside_map && !blocked.in_zone) {
    best_area_ = candidate.box.area();
    best_angle_ = candidate.angle;
    best_ = {.frame = frame, .box = candidate.box};
    candidate.bound = kDone;
    return;
  }
  const std::span<const CellIndex> cells(found.data(), blocked.count);
  learn(repair, candidate.box, cells);
  if (blocked.outside_map) repair.add_outside_points(candidate.box, points_);
  if (blocked.in_zone) learn_zones(obstacles, frame, candidate.box, radius_, points_);
  // A box shrunk to avoid all of them may be free and large enough.
  Box pulled = candidate.box;
  bool possible = !blocked.in_zone && (!blocked.outside_map || repair.pull_into_map(pulled));
  for (std::size_t i = 0; i < cells.size() && possible; ++i)
    possible = repair.pull_from(cells[i], pulled) && pulled.area() > best_area_;
  if (possible) accept_if_free(obstacles, candidate, pulled);
  if (candidate.tests >= kTestsPerAngle) {
    accept_if_free(obstacles, candidate, candidate.core);
    candidate.bound = kDone;
  }
}

void RectangleSearch::exhaust(const BitGrid& obstacles) noexcept {
  while (tests_ < kTestsInAll) {
    Candidate* best = nullptr;
    for (std::size_t i = 0; i < num_candidates_; ++i) {
      if (best == nullptr || candidates_[i].bound > best->bound) best = &candidates_[i];
    }
    if (best == nullptr || best->bound <= worthwhile()) return;
    if (is_up_to_date(*best)) {
      test(obstacles, *best);
    } else {
      evaluate(*best);
    }
  }
}

std::optional<RectangleSearch::Found> RectangleSearch::find(const BitGrid& obstacles,
                                                            double clearance,
                                                            std::span<const Anchor> anchors,
                                                            const RectangleSearchSettings& settings,
                                                            std::optional<double> hint) noexcept {
  FAIRWAY_EXPECTS(!anchors.empty());
  grid_ = &obstacles.frame();
  anchors_ = anchors;
  origin_ = anchors[0].point;
  radius_ = search_radius(*grid_, clearance);
  longest_ = settings.longest_side / grid_->resolution;
  tolerance_ = settings.tolerance;
  num_candidates_ = 0;
  tests_ = 0;
  best_area_ = -1.0;
  if (!is_free(obstacles, TurnedBox{.origin = origin_}, radius_)) return std::nullopt;

  points_.look_around(obstacles, origin_, radius_, longest_);
  look_at_zones(obstacles, origin_, radius_, longest_, points_);
  double spacing = kQuarterTurn / settings.num_orientations;
  for (int k = 0; k < settings.num_orientations; ++k)
    try_angle(k * spacing);
  if (hint) try_angle(*hint);
  if (const auto zone = direction_of_nearest_zone(obstacles, origin_, longest_)) try_angle(*zone);
  exhaust(obstacles);
  // A maze may exhaust the tests before an orientation is found that contains all anchors.
  for (std::size_t i = num_candidates_; i-- > 0 && best_area_ < 0.0;)
    accept_if_free(obstacles, candidates_[i], candidates_[i].core);
  for (int i = 0; i < settings.refinements && best_area_ >= 0.0; ++i) {
    spacing *= 0.5;
    const double center = best_angle_;
    try_angle(center - spacing);
    try_angle(center + spacing);
    exhaust(obstacles);
  }
  if (best_area_ < 0.0) return std::nullopt;
  return best_;
}

std::optional<OrientedRectangle> largest_rectangle(const BitGrid& obstacles,
                                                   double clearance,
                                                   const Anchor& seed,
                                                   std::span<const Anchor> others,
                                                   const RectangleSearchSettings& settings) {
  const GridFrame& grid = obstacles.frame();
  std::vector<Anchor> anchors;
  const auto add = [&](const Anchor& anchor) {
    anchors.push_back(
        {.point = grid.to_grid(anchor.point), .margin = anchor.margin / grid.resolution});
    return is_finite(anchors.back().point) && std::isfinite(anchor.margin);
  };
  if (!add(seed) || !std::all_of(others.begin(), others.end(), add)) return std::nullopt;
  RectangleSearch search;
  const auto found = search.find(obstacles, clearance, anchors, settings);
  if (!found) return std::nullopt;
  OrientedRectangle result = to_world(grid, found->frame, found->box);
  result.seed = seed.point;
  if (!is_free(obstacles, result, clearance)) return std::nullopt;
  return result;
}

}  // namespace fairway
