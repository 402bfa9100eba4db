// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/corridor_builder.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fairway/corridor/fewest_rectangles.hpp"
#include "fairway/corridor/sequential_rectangles.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

// The differences between two maps inside a block.
struct Difference {
  bool any = false;
  CellWindow freed = kNoCells;  // bounding window of the cells that became free
};

// Copies the block of `now` into `known` and returns what changed.
Difference take_over(const BitGrid& now, const CellWindow& changed, BitGrid& known) noexcept {
  Difference difference;
  const CellWindow inside = clipped(changed, now.frame());
  for (int y = inside.first.y; y <= inside.last.y; ++y) {
    for (int x = inside.first.x; x <= inside.last.x; ++x) {
      const CellIndex cell{.x = x, .y = y};
      const bool blocked = now.blocked(cell);
      if (blocked == known.blocked(cell)) continue;
      difference.any = true;
      known.set(cell, blocked);
      if (!blocked) difference.freed = united(difference.freed, {.first = cell, .last = cell});
    }
  }
  return difference;
}

OrientedRectangle in_world(const GridFrame& frame, const CellWindow& window) noexcept {
  const Vector2d cells(window.last.x - window.first.x + 1, window.last.y - window.first.y + 1);
  return {.seed = frame.to_world({window.first.x, window.first.y}),
          .orientation = frame.origin.heading,
          .min = Vector2d::Zero(),
          .max = cells * frame.resolution};
}

// Where there is hardly space for the overlap required, a chain of more rectangles may still exist.
CorridorResult with_more_rectangles(const BitGrid& obstacles,
                                    const Path& path,
                                    double robot_radius,
                                    const CorridorSettings& settings,
                                    const CorridorResult& stuck) {
  CorridorResult other = build_sequential(obstacles, path, robot_radius, settings);
  return other.status == CorridorStatus::Built ? other : stuck;
}

// Returns whether a corridor can be built with these numbers; this form also rejects NaN.
bool is_valid(double robot_radius, const CorridorSettings& settings) noexcept {
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  const auto not_negative = [](double value) { return value >= 0.0 && std::isfinite(value); };
  return not_negative(robot_radius) && not_negative(settings.inward_offset) &&
         not_negative(settings.min_overlap_area) && positive(settings.growth_step) &&
         positive(settings.max_growth) && positive(settings.longest_side) &&
         positive(settings.waypoint_spacing) && settings.num_orientations > 0;
}

}  // namespace

CorridorResult build_corridor(const BitGrid& obstacles,
                              const Path& path,
                              double robot_radius,
                              const CorridorSettings& settings) {
  if (!is_valid(robot_radius, settings)) return {.status = CorridorStatus::InvalidInput};
  if (settings.method == CorridorMethod::Mdsrc)
    return build_sequential(obstacles, path, robot_radius, settings);
  FewestRectangles fewest;
  const CorridorResult& result = fewest.build(obstacles, path, robot_radius, settings);
  if (result.status != CorridorStatus::NoOverlap) return result;
  return with_more_rectangles(obstacles, path, robot_radius, settings, result);
}

struct CorridorBuilder::State {
  const CorridorResult& build(const BitGrid& obstacles,
                              const Path& path,
                              double robot_radius,
                              const CorridorSettings& settings);
  const CorridorResult& update(const BitGrid& obstacles, const CellWindow& changed);
  const CorridorResult& rebuild(const BitGrid& obstacles);

  FewestRectangles fewest_;
  CorridorResult result_;
  Path path_;
  double robot_radius_ = 0.0;
  CorridorSettings settings_;
  BitGrid known_;  // the map for which the corridor was built
  bool has_path_ = false;
  bool can_repair_ = false;  // whether fewest_ holds the chain of result_
};

const CorridorResult& CorridorBuilder::State::build(const BitGrid& obstacles,
                                                    const Path& path,
                                                    double robot_radius,
                                                    const CorridorSettings& settings) {
  path_.waypoints.assign(path.waypoints.begin(), path.waypoints.end());
  robot_radius_ = robot_radius;
  settings_ = settings;
  has_path_ = is_valid(robot_radius, settings);
  if (!has_path_) {
    result_ = {.status = CorridorStatus::InvalidInput};
    return result_;
  }
  return rebuild(obstacles);
}

const CorridorResult& CorridorBuilder::State::rebuild(const BitGrid& obstacles) {
  known_ = obstacles;
  can_repair_ = false;
  if (settings_.method == CorridorMethod::Mdsrc) {
    result_ = build_sequential(obstacles, path_, robot_radius_, settings_);
  } else {
    result_ = fewest_.build(obstacles, path_, robot_radius_, settings_);
    can_repair_ = result_.status == CorridorStatus::Built;
    if (result_.status == CorridorStatus::NoOverlap)
      result_ = with_more_rectangles(obstacles, path_, robot_radius_, settings_, result_);
  }
  return result_;
}

const CorridorResult& CorridorBuilder::State::update(const BitGrid& obstacles,
                                                     const CellWindow& changed) {
  if (!has_path_) return result_;
  if (!can_repair_ || !same_frame(obstacles.frame(), known_.frame())) return rebuild(obstacles);
  const Difference difference = take_over(obstacles, changed, known_);
  if (!difference.any) return result_;
  const bool any_freed = !is_empty(difference.freed);

  const bool workspace = settings_.space == CorridorSpace::Workspace;
  const double clearance = workspace ? 0.0 : robot_radius_;
  const double beside = clearance + 2.0 * obstacles.frame().resolution;
  const auto outdated = [&](const OrientedRectangle& rectangle) {
    const bool may_grow =
        any_freed &&
        overlap(rectangle.shrunk(-beside), in_world(obstacles.frame(), difference.freed)).count > 0;
    return may_grow || !is_free(obstacles, rectangle, clearance);
  };
  result_ = fewest_.repair(obstacles, any_freed, outdated);
  if (result_.status != CorridorStatus::Built) return rebuild(obstacles);
  return result_;
}

CorridorBuilder::CorridorBuilder() : state_(std::make_unique<State>()) {}
CorridorBuilder::CorridorBuilder(CorridorBuilder&&) noexcept = default;
CorridorBuilder& CorridorBuilder::operator=(CorridorBuilder&&) noexcept = default;
CorridorBuilder::~CorridorBuilder() = default;

const CorridorResult& CorridorBuilder::build(const BitGrid& obstacles,
                                             const Path& path,
                                             double robot_radius,
                                             const CorridorSettings& settings) {
  return state_->build(obstacles, path, robot_radius, settings);
}

const CorridorResult& CorridorBuilder::update(const BitGrid& obstacles, const CellWindow& changed) {
  return state_->update(obstacles, changed);
}

const CorridorResult& CorridorBuilder::result() const noexcept { return state_->result_; }

}  // namespace fairway
