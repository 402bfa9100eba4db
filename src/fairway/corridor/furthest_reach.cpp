// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/furthest_reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "fairway/base/simd.hpp"
#include "fairway/corridor/rectangle/box_repair.hpp"
#include "fairway/corridor/rectangle/zone_points.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kNowhere = std::numeric_limits<double>::infinity();

// Returns whether an obstacle point lies in the box.
bool holds_point(const ObstaclePoints& points, const TurnedFrame& frame, const Box& box) noexcept {
  const auto c = static_cast<float>(frame.along.x());
  const auto s = static_cast<float>(frame.along.y());
  // For each point: its distance from the box's centre minus the half size, per axis. The half size
  // is reduced by a tolerance, so that rounding never moves a point on the border inside.
  constexpr double kTolerance = 1e-3;
  const Vector2d center = box.center();
  const Vector2d half = 0.5 * (box.max - box.min) - Vector2d::Constant(kTolerance);
  const auto center_x = static_cast<float>(center.x());
  const auto center_y = static_cast<float>(center.y());
  const auto half_x = static_cast<float>(half.x());
  const auto half_y = static_cast<float>(half.y());
  // The newest points are tested first: boxes like this one met them.
  constexpr std::size_t kAtOnce = 16;
  for (std::size_t end = (points.size() + 3) / 4 * 4; end > 0;) {
    const std::size_t begin = end > kAtOnce ? end - kAtOnce : 0;
    Pack4f least = four(1.0F);
    for (std::size_t i = begin; i < end; i += 4) {
      const Pack4f px = load4(points.x() + i);
      const Pack4f py = load4(points.y() + i);
      const Pack4f x = c * px + s * py - center_x;
      const Pack4f y = c * py - s * px - center_y;
      // Missing points are NaN, and compare false.
      least = min(max(max(x, -x) - half_x, max(y, -y) - half_y), least);
    }
    if (std::min(std::min(least[0], least[1]), std::min(least[2], least[3])) < 0.0F) return true;
    end = begin;
  }
  return false;
}

}  // namespace

PathPiece ReachSearch::piece_to(double end) const noexcept {
  return {.begin = begin_,
          .end = {.from = end, .to = end, .margin = settings_.margin},
          .margin = settings_.margin};
}

PathPiece ReachSearch::joined_piece_to(double end) const noexcept {
  if (end >= track_->length()) return piece_to(end);
  Joint joint = shape_;
  joint.from = std::max(begin_.from, end - (shape_.to - shape_.from));
  joint.to = end;
  return {.begin = begin_, .end = joint, .margin = settings_.margin};
}

bool ReachSearch::fits(const TurnedFrame& frame, const PathPiece& piece) noexcept {
  const Box box = piece.bounds(*track_, frame);
  if ((box.max - box.min).maxCoeff() > settings_.longest_side) return false;
  if (holds_point(points_, frame, box)) return false;
  constexpr std::size_t kLearned = 2;
  std::array<CellIndex, kLearned> found;
  const BlockedCells blocked =
      find_blocked_cells(*obstacles_, frame.region(box), settings_.radius, origin_, found);
  if (blocked.in_zone) learn_zones(*obstacles_, frame, box, settings_.radius, points_);
  if (blocked.count == 0) return !blocked.outside_map && !blocked.in_zone;
  const Box core;
  const BoxRepair repair{
      .grid = obstacles_->frame(), .frame = frame, .core = core, .radius = settings_.radius};
  for (std::size_t i = 0; i < blocked.count; ++i)
    for (const Eigen::Vector2d& point : repair.points_inside(found[i], box))
      points_.add(point);
  return false;
}

// Finds how far the path fits, within the precision. @return false if that is less than `least`.
bool ReachSearch::find_plain_reach(Direction& direction,
                                   const TurnedFrame& frame,
                                   double least) noexcept {
  const double length = track_->length();
  double& good = direction.good;
  double& bad = direction.bad;
  if (good >= 0.0 || bad <= least) return good >= least;
  if (!fits(frame, piece_to(least))) {
    bad = least;
    return false;
  }
  good = least;
  // Double the step while the piece fits, then bisect.
  if (fits(frame, piece_to(length))) {
    good = length;
  } else {
    bad = std::min(bad, length);
    for (double step = 4.0; good + step < bad; step *= 2.0) {
      if (!fits(frame, piece_to(good + step))) {
        bad = good + step;
        break;
      }
      good += step;
    }
    while (bad - good > settings_.precision) {
      const double middle = 0.5 * (good + bad);
      (fits(frame, piece_to(middle)) ? good : bad) = middle;
    }
  }
  // A corner of the path just ahead is reached exactly, because the next line begins there.
  const std::size_t next = track_->segment(good) + 1;
  const double corner = next < track_->arc().size() ? track_->arc()[next] : length;
  if (corner < bad && corner > good && fits(frame, piece_to(corner))) good = corner;
  return true;
}

void ReachSearch::try_direction(Direction& direction) noexcept {
  const TurnedFrame frame{.origin = origin_, .along = fairway::direction(direction.angle)};
  const double length = track_->length();
  const double least = best_.found ? best_.end.to + settings_.precision : begin_.to;
  if (least > length || (best_.found && best_.end.to >= length)) return;
  if (!find_plain_reach(direction, frame, least)) return;
  // Step back to where the joint fits.
  double step = settings_.precision;
  for (double end = direction.good; end >= least; end -= step, step *= 1.2) {
    const PathPiece piece = joined_piece_to(end);
    if (!fits(frame, piece)) continue;
    best_ = {.end = piece.end, .angle = direction.angle, .found = true};
    return;
  }
}

void ReachSearch::start(const BitGrid& obstacles,
                        const PathTrack& track,
                        const Joint& begin,
                        const Settings& settings) noexcept {
  constexpr double kQuarterTurn = std::numbers::pi / 2.0;
  obstacles_ = &obstacles;
  track_ = &track;
  settings_ = settings;
  begin_ = begin;
  origin_ = track.at(begin.from);
  num_directions_ = 0;
  if (!is_free(obstacles, TurnedBox{.origin = origin_}, settings.radius)) return;
  // A reach learns what blocks it from the exact tests, so a coarse first guess gives the same one.
  constexpr std::size_t kRaySpacing = 4;
  points_.look_around(obstacles, origin_, settings.radius, settings.longest_side, kRaySpacing);
  look_at_zones(obstacles, origin_, settings.radius, settings.longest_side, points_);

  const auto add = [&](double angle) {
    directions_[num_directions_++] = {.angle = angle, .bad = kNowhere};
  };
  // Directions of the next few straight lines: along a free line there is always a free rectangle.
  const std::size_t first = track.segment(begin.from);
  for (std::size_t i = first; i + 1 < track.points().size() && i < first + kPathDirections; ++i) {
    const Vector2d line = track.points()[i + 1] - track.points()[i];
    add(std::atan2(line.y(), line.x()));
  }
  for (int k = 0; k < settings.num_orientations; ++k)
    add(k * kQuarterTurn / settings.num_orientations);
}

Reach ReachSearch::find(const Joint& shape) noexcept {
  shape_ = shape;
  best_ = {};
  for (std::size_t i = 0; i < num_directions_; ++i)
    try_direction(directions_[i]);
  double spacing = std::numbers::pi / 2.0 / settings_.num_orientations;
  for (int i = 0; i < settings_.refinements && best_.found; ++i) {
    spacing *= 0.5;
    const double center = best_.angle;
    for (const double angle : {center - spacing, center + spacing}) {
      Direction between{.angle = angle, .bad = kNowhere};
      try_direction(between);
    }
  }
  return best_;
}

}  // namespace fairway
