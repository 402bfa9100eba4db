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
  std::optional<CellBlock> freed;  // bounding block of the cells that became free
};

// Copies the block of `now` into `known` and returns what changed.
Difference take_over(const BitGrid& now, const CellBlock& changed, BitGrid& known) noexcept {
  Difference difference;
  const int left = std::max(changed.min.x, 0);
  const int right = std::min(changed.max.x, now.frame().width - 1);
  const int top = std::min(changed.max.y, now.frame().height - 1);
  for (int y = std::max(changed.min.y, 0); y <= top; ++y) {
    for (int x = left; x <= right; ++x) {
      const CellIndex cell{.x = x, .y = y};
      const bool blocked = now.blocked(cell);
      if (blocked == known.blocked(cell)) continue;
      difference.any = true;
      known.set(cell, blocked);
      if (blocked) continue;
      if (!difference.freed) difference.freed = CellBlock{.min = cell, .max = cell};
      CellBlock& freed = *difference.freed;
      freed.min = {.x = std::min(freed.min.x, x), .y = std::min(freed.min.y, y)};
      freed.max = {.x = std::max(freed.max.x, x), .y = std::max(freed.max.y, y)};
    }
  }
  return difference;
}

OrientedRectangle in_world(const GridFrame& frame, const CellBlock& block) noexcept {
  return {.seed = frame.to_world({block.min.x, block.min.y}),
          .orientation = frame.origin.heading,
          .min = Vector2d::Zero(),
          .max = Vector2d(block.max.x - block.min.x + 1, block.max.y - block.min.y + 1) *
                 frame.resolution};
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
  const CorridorResult& update(const BitGrid& obstacles, const CellBlock& changed);
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
                                                     const CellBlock& changed) {
  if (!has_path_) return result_;
  if (!can_repair_ || !same_frame(obstacles.frame(), known_.frame())) return rebuild(obstacles);
  const Difference difference = take_over(obstacles, changed, known_);
  if (!difference.any) return result_;

  const bool workspace = settings_.space == CorridorSpace::Workspace;
  const double clearance = workspace ? 0.0 : robot_radius_;
  const double beside = clearance + 2.0 * obstacles.frame().resolution;
  const auto outdated = [&](const OrientedRectangle& rectangle) {
    const bool may_grow =
        difference.freed &&
        overlap(rectangle.shrunk(-beside), in_world(obstacles.frame(), *difference.freed)).count >
            0;
    return may_grow || !is_free(obstacles, rectangle, clearance);
  };
  result_ = fewest_.repair(obstacles, difference.freed.has_value(), outdated);
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

const CorridorResult& CorridorBuilder::update(const BitGrid& obstacles, const CellBlock& changed) {
  return state_->update(obstacles, changed);
}

const CorridorResult& CorridorBuilder::result() const noexcept { return state_->result_; }

}  // namespace fairway
