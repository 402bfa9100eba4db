// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/fewest_rectangles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fairway {

namespace {

using Eigen::Vector2d;

// Room between the path and the sides, so that start and goal are inside whatever rounding does
// [m].
constexpr double kInside = 1e-7;

// A sixteenth of the disc is the least that a joint is tried with.
constexpr int kJointLevels = 5;

struct JointShape {
  double margin;
  double length;
};

// The shape of a joint with at least the area asked for: a disc, or at higher levels a disc of half
// the radius each time, swept along a straight line.
JointShape joint_shape(double area, int level) noexcept {
  constexpr double kSpare = 1.0 + 1e-6;  // against rounding
  const double margin = std::sqrt(area * kSpare / std::numbers::pi) / (1 << level);
  if (level == 0) return {.margin = margin, .length = 0.0};
  return {.margin = margin,
          .length = (area * kSpare - std::numbers::pi * margin * margin) / (2.0 * margin)};
}

// How deep inside the box a point is; negative outside.
double depth(const RectangleSearch::Found& found, const Vector2d& point) noexcept {
  const Vector2d p = found.frame.turned(point - found.frame.origin);
  return std::min((p - found.box.min).minCoeff(), (found.box.max - p).minCoeff());
}

// The same rectangle, counted from another seed.
void reseed(OrientedRectangle& rectangle, const Vector2d& seed) noexcept {
  const Vector2d moved = rectangle.to_local(seed);
  rectangle.min -= moved;
  rectangle.max -= moved;
  rectangle.seed = seed;
}

}  // namespace

bool FewestRectangles::plan_links(const BitGrid& obstacles, double min_overlap) {
  constexpr double kProgress =
      1e-6;  // [cells]; a reach ends at a corner or a good part of a cell on
  links_.clear();
  Joint begin{.from = 0.0, .to = 0.0, .margin = reach_settings_.margin};
  const double goal = track_.length();
  while (true) {
    Reach reach;
    const int levels = min_overlap > 0.0 ? kJointLevels : 1;
    for (int level = 0; level < levels; ++level) {
      const JointShape shape = joint_shape(min_overlap, level);
      reach = reach_.find(obstacles, track_, begin, reach_settings_.margin + shape.margin,
                          shape.length, reach_settings_);
      const bool arrived = reach.found && reach.end.to >= goal;
      const bool onward = reach.found && reach.end.from > begin.from + kProgress &&
                          reach.end.to > begin.to + kProgress;
      if (arrived || onward) break;
      reach.found = false;
    }
    if (!reach.found) return false;
    links_.push_back({.piece = {.begin = begin, .end = reach.end, .margin = reach_settings_.margin},
                      .angle = reach.angle});
    if (reach.end.to >= goal) return true;
    begin = reach.end;
  }
}

bool FewestRectangles::add_rectangle(const BitGrid& obstacles,
                                     const PathPiece& piece,
                                     double angle,
                                     Corridor& corridor) {
  anchors_.clear();
  anchors_.push_back(
      {.point = track_.at(0.5 * (piece.begin.from + piece.end.to)), .margin = piece.margin});
  piece.visit(track_, [&](const Vector2d& point, double margin) {
    anchors_.push_back({.point = point, .margin = margin});
  });
  const auto found = search_.find(obstacles, clearance_, anchors_, rectangle_settings_, angle);
  if (!found) return false;
  last_found_ = *found;
  corridor.rectangles.push_back(to_world(obstacles.frame(), found->frame, found->box));
  const double resolution = obstacles.frame().resolution;
  corridor.spans.push_back(
      {.from = piece.begin.from * resolution, .to = piece.end.to * resolution});
  return true;
}

// The joint of the same shape as `latest`, nearest to the start, that the rectangle holds without a
// gap from `latest` on.
Joint FewestRectangles::joint_towards_start(const RectangleSearch::Found& found,
                                            const Joint& latest) const noexcept {
  constexpr double kStep = 1.0;  // [cells]
  const double length = latest.to - latest.from;
  Joint joint = latest;
  if (length > 0.0) return joint;  // in a narrow place nothing is to be gained
  // A box that holds both ends of a straight line holds the line: stop at every corner.
  for (double s = latest.from; s > 0.0;) {
    const double corner = track_.arc()[track_.segment(s)];
    s = std::max(s - kStep, corner < s ? corner : track_.arc()[track_.segment(s) - 1]);
    const double room = depth(found, track_.at(s));
    if (room < reach_settings_.margin) break;
    if (s > 0.0 && room >= latest.margin) joint.from = joint.to = s;
  }
  return joint;
}

bool FewestRectangles::fill_links(const BitGrid& obstacles,
                                  const Vector2d& start,
                                  Corridor& corridor) {
  if (links_.empty()) return false;
  Joint end = links_.back().piece.end;
  for (std::size_t i = links_.size(); i-- > 0;) {
    const Link& link = links_[i];
    PathPiece piece = link.piece;
    piece.end = end;
    // Where less is left to this one, it can grow to other sides; but the new joint may not fit.
    if (!add_rectangle(obstacles, piece, link.angle, corridor) &&
        !add_rectangle(obstacles, link.piece, link.angle, corridor)) {
      return false;
    }
    if (i > 0) {
      end = joint_towards_start(last_found_, link.piece.begin);
      corridor.spans.back().from = end.from * obstacles.frame().resolution;
    }
    OrientedRectangle& rectangle = corridor.rectangles.back();
    reseed(rectangle, i > 0 ? obstacles.frame().to_world(track_.at(end.from)) : start);
    if (!is_free(obstacles, rectangle, clearance_)) return false;
  }
  std::reverse(corridor.rectangles.begin(), corridor.rectangles.end());
  std::reverse(corridor.spans.begin(), corridor.spans.end());
  return true;
}

CorridorResult FewestRectangles::build(const BitGrid& obstacles,
                                       const Path& path,
                                       double robot_radius,
                                       const CorridorSettings& settings) {
  CorridorResult result;
  Corridor& corridor = result.corridor;
  const bool workspace = settings.space == CorridorSpace::Workspace;
  corridor.space = settings.space;
  corridor.robot_radius = robot_radius;
  corridor.inward_offset = workspace ? settings.inward_offset : 0.0;
  const GridFrame& grid = obstacles.frame();
  if (!track_.assign(path, grid)) return result;

  const double cell = grid.resolution;
  clearance_ = workspace ? 0.0 : robot_radius;
  rectangle_settings_ = {.longest_side = settings.longest_side};
  reach_settings_ = {.radius = search_radius(grid, clearance_),
                     .longest_side = settings.longest_side / cell,
                     .margin = (corridor.inward_offset + kInside) / cell};
  const bool planned = plan_links(obstacles, settings.min_overlap_area / (cell * cell));
  if (fill_links(obstacles, path.waypoints.front(), corridor) && planned) {
    result.status = CorridorStatus::Built;
    return result;
  }
  const double stuck = links_.empty() ? 0.0 : links_.back().piece.end.to;
  result.stuck_at = stuck * cell;
  result.stuck_waypoint = waypoint_before(path, result.stuck_at);
  // Without a joint to make, would a rectangle continue? Then it is the joint that fails.
  const Reach onward =
      reach_.find(obstacles, track_, {.from = stuck, .to = stuck, .margin = reach_settings_.margin},
                  reach_settings_.margin, 0.0, reach_settings_);
  result.status = onward.found && onward.end.to > stuck + 1.0 ? CorridorStatus::NoOverlap
                                                              : CorridorStatus::SeedBlocked;
  return result;
}

}  // namespace fairway
