// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/fewest_rectangles.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/corridor/joint_shape.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

// Distance between the path and the sides [m], so that start and goal are inside in spite of
// rounding.
constexpr double kInside = 1e-7;

// Depth of a point inside the box [cells]; negative outside.
double depth(const RectangleSearch::Found& found, const Vector2d& point) noexcept {
  const Vector2d p = found.frame.turned(point - found.frame.origin);
  return std::min((p - found.box.min).minCoeff(), (found.box.max - p).minCoeff());
}

// Changes the seed of a rectangle, and keeps its place.
void reseed(OrientedRectangle& rectangle, const Vector2d& seed) noexcept {
  const Vector2d moved = rectangle.to_local(seed);
  rectangle.min -= moved;
  rectangle.max -= moved;
  rectangle.seed = seed;
}

}  // namespace

Reach FewestRectangles::onward_reach(const BitGrid& obstacles, const Joint& begin) {
  // Every reach ends at a corner or a good part of a cell further, so any progress suffices
  // [cells].
  constexpr double kProgress = 1e-6;
  // With less progress than this, other joints are tried, which may lead further. A joint centred
  // on the path is preferred.
  constexpr double kGoodProgress = 20.0;  // [cells]
  constexpr double kFairProgress = 5.0;   // [cells]
  const int shapes = min_overlap_ > 0.0 ? internal::kJointShapes : 1;
  Reach best;
  reach_.start(obstacles, track_, begin, reach_settings_);
  for (int number = 0; number < shapes; ++number) {
    const Reach reach =
        reach_.find(internal::joint_shape(min_overlap_, number, reach_settings_.margin));
    if (!reach.found) continue;
    if (reach.end.to >= track_.length()) return reach;
    const bool onward =
        reach.end.from > begin.from + kProgress && reach.end.to > begin.to + kProgress;
    if (!onward || (best.found && reach.end.to <= best.end.to)) continue;
    best = reach;
    if (reach.end.to > begin.to + (number == 0 ? kFairProgress : kGoodProgress)) break;
  }
  return best;
}

// Tries to end the new links at an old one. One rectangle, where the reach was found, must lead to
// the joint at the beginning of that old link. The furthest few such links are tried.
bool FewestRectangles::hook(const BitGrid& obstacles,
                            const Joint& begin,
                            const Reach& reach,
                            std::size_t first_old) {
  std::size_t next = first_old;
  while (next < links_.size() && links_[next].piece.begin.to <= reach.end.to)
    ++next;
  const TurnedFrame frame{.origin = track_.at(begin.from), .along = direction(reach.angle)};
  for (int tries = 0; tries < 3 && next > first_old; ++tries) {
    const Joint& end = links_[--next].piece.begin;
    if (end.from <= begin.from) return false;
    const PathPiece piece{.begin = begin, .end = end, .margin = reach_settings_.margin};
    if (!is_free(obstacles, frame.region(piece.bounds(track_, frame)), reach_settings_.radius))
      continue;
    fresh_.push_back({.piece = piece, .angle = reach.angle, .rectangle = {}});
    hooked_ = next;
    return true;
  }
  return false;
}

// Fills fresh_ with links from `begin` to the goal, or to the old link hooked_, at or after
// `first_old`.
bool FewestRectangles::plan(const BitGrid& obstacles, Joint begin, std::size_t first_old) {
  fresh_.clear();
  while (true) {
    const Reach reach = onward_reach(obstacles, begin);
    if (!reach.found) {
      record_break(obstacles, begin);
      return false;
    }
    if (reach.end.to < track_.length() && hook(obstacles, begin, reach, first_old)) return true;
    fresh_.push_back({.piece = {.begin = begin, .end = reach.end, .margin = reach_settings_.margin},
                      .angle = reach.angle,
                      .rectangle = {}});
    hooked_ = links_.size();
    if (reach.end.to >= track_.length()) return true;
    begin = reach.end;
  }
}

bool FewestRectangles::make_rectangle(const BitGrid& obstacles, Link& link) {
  const PathPiece& piece = link.piece;
  anchors_.clear();
  anchors_.push_back(
      {.point = track_.at(0.5 * (piece.begin.from + piece.end.to)), .margin = piece.margin});
  piece.visit(track_, [&](const Vector2d& point, double margin) {
    anchors_.push_back({.point = point, .margin = margin});
  });
  const auto found = search_.find(obstacles, clearance_, anchors_, rectangle_settings_, link.angle);
  if (!found) return false;
  last_found_ = *found;
  link.rectangle = to_world(obstacles.frame(), found->frame, found->box);
  return true;
}

// Moves a joint towards the start, as far as the last rectangle contains it. The shape of `latest`
// is kept, and the rectangle contains the path between the two.
Joint FewestRectangles::joint_towards_start(const Joint& latest) const noexcept {
  constexpr double kStep = 1.0;  // [cells]
  Joint joint = latest;
  if (latest.to > latest.from || latest.beside()) return joint;  // a narrow place: nothing to gain
  // A box that contains both ends of a straight line contains the line, so each corner is checked.
  for (double s = latest.from; s > 0.0;) {
    const double corner = track_.arc()[track_.segment(s)];
    s = std::max(s - kStep, corner < s ? corner : track_.arc()[track_.segment(s) - 1]);
    const double inside = depth(last_found_, track_.at(s));
    if (inside < reach_settings_.margin) break;
    if (s > 0.0 && inside >= latest.margin) joint.from = joint.to = s;
  }
  return joint;
}

// Computes the rectangle of every fresh link, from the last to the first. Each joint is then moved
// towards the start as far as the later rectangle reaches; the earlier one has less to contain and
// can grow more.
bool FewestRectangles::fill(const BitGrid& obstacles) {
  for (std::size_t i = fresh_.size(); i-- > 0;) {
    Link& link = fresh_[i];
    if (i + 1 < fresh_.size()) {
      const Joint planned = link.piece.end;
      link.piece.end = fresh_[i + 1].piece.begin;
      // The moved joint may have too little clearance here; then use the planned one.
      if (!make_rectangle(obstacles, link)) {
        link.piece.end = planned;
        fresh_[i + 1].piece.begin = planned;
        if (!make_rectangle(obstacles, link)) return false;
      }
    } else if (!make_rectangle(obstacles, link)) {
      return false;
    }
    if (i == 0) continue;
    const Joint& before = fresh_[i - 1].piece.begin;
    const Joint moved = joint_towards_start(link.piece.begin);
    if (moved.from > before.to) link.piece.begin = moved;
  }
  for (Link& link : fresh_) {
    const bool at_start = link.piece.begin.from <= 0.0;
    reseed(link.rectangle, at_start ? path_.waypoints.front()
                                    : obstacles.frame().to_world(track_.at(link.piece.begin.from)));
    if (!is_free(obstacles, link.rectangle, clearance_)) return false;
  }
  return true;
}

// Records where and why the chain ending at `begin` stops. If the path is blocked slightly further
// on, where joints have no clearance, the path is the reason; otherwise the joint is.
void FewestRectangles::record_break(const BitGrid& obstacles, const Joint& begin) {
  const double nearby = 2.0 * begin.margin + 2.0;
  double stuck = begin.to;
  const auto plain_reach = [&](double from) {
    const Joint joint{.from = from, .to = from, .margin = reach_settings_.margin};
    reach_.start(obstacles, track_, joint, reach_settings_);
    const Reach reach = reach_.find({.margin = reach_settings_.margin});
    return reach.found ? reach.end.to : from;
  };
  const double first = plain_reach(stuck);
  const bool blocked = first < track_.length() && first - stuck < nearby &&
                       plain_reach(first) - first < reach_settings_.precision;
  result_.status = blocked ? CorridorStatus::SeedBlocked : CorridorStatus::NoOverlap;
  if (blocked) stuck = first;
  result_.stuck_at = stuck * obstacles.frame().resolution;
  result_.stuck_waypoint = waypoint_before(path_, result_.stuck_at);
}

// Finds an orientation, near the old one, in which one rectangle can still contain the piece of a
// link.
bool FewestRectangles::find_turn(const BitGrid& obstacles, Link& link) const noexcept {
  const double spacing = std::numbers::pi / 2.0 / reach_settings_.num_orientations;
  TurnedFrame frame{.origin = track_.at(link.piece.begin.from)};
  for (int k = 0; k < reach_settings_.num_orientations; ++k) {
    const double angle = link.angle + (k % 2 == 0 ? 0.5 : -0.5) * (k + k % 2) * spacing;
    frame.along = direction(angle);
    const Box box = link.piece.bounds(track_, frame);
    if ((box.max - box.min).maxCoeff() > reach_settings_.longest_side) continue;
    if (!is_free(obstacles, frame.region(box), reach_settings_.radius)) continue;
    link.angle = angle;
    return true;
  }
  return false;
}

// Fills fresh_ with the pieces of links `first` to `last` - 1, with new orientations.
bool FewestRectangles::keep_joints(const BitGrid& obstacles, std::size_t first, std::size_t last) {
  fresh_.assign(links_.begin() + static_cast<std::ptrdiff_t>(first),
                links_.begin() + static_cast<std::ptrdiff_t>(last));
  hooked_ = last;
  return std::all_of(fresh_.begin(), fresh_.end(),
                     [&](Link& link) { return find_turn(obstacles, link); }) &&
         fill(obstacles);
}

// Replaces links `first` to `last` - 1, and later ones if the new links reach further. If the chain
// breaks, it ends there. @return the index of the first old link after the new ones.
std::size_t FewestRectangles::replace(const BitGrid& obstacles,
                                      std::size_t first,
                                      std::size_t last,
                                      bool may_be_fewer) {
  const Joint start{.from = 0.0, .to = 0.0, .margin = reach_settings_.margin};
  const Joint begin = first < links_.size() ? links_[first].piece.begin : start;
  result_.status = CorridorStatus::Built;
  if (may_be_fewer || !keep_joints(obstacles, first, last)) {
    const bool planned = plan(obstacles, begin, last);
    const bool filled = fill(obstacles);
    if (!planned || !filled) {
      hooked_ = links_.size();
      if (planned) record_break(obstacles, begin);  // no known input leads here
      if (!filled) fresh_.clear();
    }
  }
  const auto at = links_.erase(links_.begin() + static_cast<std::ptrdiff_t>(first),
                               links_.begin() + static_cast<std::ptrdiff_t>(hooked_));
  links_.insert(at, fresh_.begin(), fresh_.end());
  return first + fresh_.size();
}

const CorridorResult& FewestRectangles::report(const GridFrame& grid) {
  Corridor& corridor = result_.corridor;
  corridor.rectangles.clear();
  corridor.spans.clear();
  for (const Link& link : links_) {
    corridor.rectangles.push_back(link.rectangle);
    corridor.spans.push_back({.from = link.piece.begin.from * grid.resolution,
                              .to = link.piece.end.to * grid.resolution});
  }
  return result_;
}

const CorridorResult& FewestRectangles::build(const BitGrid& obstacles,
                                              const Path& path,
                                              double robot_radius,
                                              const CorridorSettings& settings) {
  const bool workspace = settings.space == CorridorSpace::Workspace;
  const GridFrame& grid = obstacles.frame();
  result_.corridor.space = settings.space;
  result_.corridor.robot_radius = robot_radius;
  result_.corridor.inward_offset = workspace ? settings.inward_offset : 0.0;
  result_.status = CorridorStatus::EmptyPath;
  result_.stuck_at = 0.0;
  result_.stuck_waypoint = 0;
  links_.clear();
  path_.waypoints.assign(path.waypoints.begin(), path.waypoints.end());
  if (!track_.assign(path, grid)) return report(grid);

  const double cell = grid.resolution;
  clearance_ = workspace ? 0.0 : robot_radius;
  min_overlap_ = settings.min_overlap_area / (cell * cell);
  // The orientation of the reach is tried as well, so a coarse search over the others suffices.
  // This saves much time and loses little area.
  rectangle_settings_ = {.longest_side = settings.longest_side,
                         .num_orientations = 8,
                         .refinements = 3,
                         .tolerance = 0.03};
  reach_settings_ = {.radius = search_radius(grid, clearance_),
                     .longest_side = settings.longest_side / cell,
                     .margin = (result_.corridor.inward_offset + kInside) / cell};
  replace(obstacles, 0, 0, true);
  return report(grid);
}

}  // namespace fairway
