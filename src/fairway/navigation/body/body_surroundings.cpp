// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/body_surroundings.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "fairway/map/grid_overlay.hpp"
#include "fairway/path/se2/goal_distance.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

// The poses are those that the caller measures, which scans do not correct.
PerceptionSettings without_matching(PerceptionSettings settings) noexcept {
  settings.match_scans = false;
  return settings;
}

}  // namespace

BodySurroundings::BodySurroundings(const Settings& settings,
                                   const BodyShape& body,
                                   const PreparedMap* shared,
                                   double reach)
    : settings_(without_matching(settings.perception)),
      unknown_(unknown_cells(settings.map)),
      body_(body),
      shared_(shared),
      reach_(reach) {
  if (shared_ != nullptr) refresh();
}

void BodySurroundings::set_settings(const Settings& settings) {
  unknown_ = unknown_cells(settings.map);
  const PerceptionSettings given = without_matching(settings.perception);
  if (given == settings_) return;
  settings_ = given;
  if (!perception_) return;
  perception_.reset();
  merged_.reset();
  seen_free_.reset();
  planned_.reset();
  proven_.reset();
  stale_ = changed_ = false;
  if (map() != nullptr) refresh();
}

void BodySurroundings::set_map(const OccupancyGrid& given) { set_map(BitGrid(given, unknown_)); }

void BodySurroundings::set_map(const BitGrid& map) {
  BitGrid bits = map;
  bits.set_zones(zones_);
  if (own_ && own_->obstacles == bits) return;  // some callers repeat it in every cycle
  if (own_ && same_frame(own_->obstacles.frame(), bits.frame())) {
    own_->update(bits, difference(bits, own_->obstacles));
  } else {
    own_.emplace(std::move(bits));
  }
  seen_free_.reset();
  merged_.reset();
  refresh();
}

void BodySurroundings::set_zones(std::shared_ptr<const ZoneMap> zones) {
  zones_ = std::move(zones);
  if (own_) own_->set_zones(zones_);
  if (perception_) perception_->set_zones(zones_);
  if (known()) refresh();
}

void BodySurroundings::note_map() { refresh(); }

bool BodySurroundings::observe(const LidarScan& scan, const Vector2d& position) {
  scan_refused_ = !is_plausible(scan, position);
  if (scan_refused_) return false;
  if (!perception_) {
    perception_.emplace(settings_, position);
    perception_->set_zones(zones_);
  }
  perception_->observe(scan, position, 0.0);
  center_ = position;
  stale_ = true;
  return true;
}

void BodySurroundings::claim(const Pose2& pose) {
  if (!mapless() || !known() || proven_->is_free(pose, 0.0)) return;
  for (const Footprint::Disc& disc : body_.cover())
    perception_->claim(transform(pose, disc.center), disc.radius);
  refresh();
}

// Prepares what plans and stops read.
void BodySurroundings::refresh() {
  changed_ = true;
  stale_ = false;
  if (perception_ && map() != nullptr) {
    drawn_ = map()->obstacles;
    add_obstacles(perception_->grid().occupied(), drawn_);
    adopt(drawn_, merged_);
  } else if (perception_) {
    adopt(perception_->grid().occupied(), merged_);
    BitGrid near = cropped(perception_->grid().not_seen_free(), center_, reach_);
    near.set_zones(zones_);
    adopt(near, seen_free_);
  }
  planned_.emplace(map_for_plans().obstacles, map_for_plans().distances, body_);
  const PreparedMap& near = seen_free_ ? *seen_free_ : map_for_plans();
  proven_.emplace(near.obstacles, near.distances, body_);
}

void BodySurroundings::adopt(const BitGrid& bits, std::optional<PreparedMap>& prepared) const {
  if (prepared) {
    const bool same = same_frame(bits.frame(), prepared->obstacles.frame());
    prepared->update(bits, same ? difference(bits, prepared->obstacles) : all_cells(bits.frame()));
    return;
  }
  prepared.emplace();
  // Greater distances do not change a plan or a proof.
  const double enough = body_.circumscribed_radius() + 1.0;  // [m]
  if (enough <= DistanceField::kMostReach * bits.frame().resolution)
    prepared->distances.set_reach(enough);
  prepared->obstacles = bits;
  prepared->measure();
}

BitGrid cropped(const BitGrid& grid, const Vector2d& center, double reach) {
  constexpr int kBlock = 64;  // cells; the part moves seldom, so that little of it changes
  const GridFrame& frame = grid.frame();
  const Vector2d at = frame.to_grid(center);
  const double half = reach / frame.resolution;
  const auto block = [&](double cell, int side) {
    const int last = std::max(0, (side - 1) / kBlock);
    return std::clamp(static_cast<int>(std::floor(cell / kBlock)), 0, last);
  };
  const int left = block(at.x() - half, frame.width);
  const int right = block(at.x() + half, frame.width);
  const int low = block(at.y() - half, frame.height) * kBlock;
  const int high = std::min(frame.height, (block(at.y() + half, frame.height) + 1) * kBlock);
  GridFrame part = frame;
  part.width = (right - left + 1) * kBlock;
  part.height = high - low;
  part.origin.position = frame.to_world(Vector2d(left * kBlock, low));
  BitGrid result(part, false);
  result.rewrite([&](auto&& row) {
    for (int y = 0; y < part.height; ++y) {
      const auto from = grid.row(low + y).subspan(static_cast<std::size_t>(left),
                                                  static_cast<std::size_t>(right - left + 1));
      std::copy(from.begin(), from.end(), row(y).begin());
    }
  });
  return result;
}

CellWindow difference(const BitGrid& a, const BitGrid& b) noexcept {
  CellWindow window = kNoCells;
  for (int y = 0; y < a.frame().height; ++y) {
    const auto first = a.row(y);
    const auto second = b.row(y);
    for (std::size_t w = 0; w < first.size(); ++w) {
      const std::uint64_t differs = first[w] ^ second[w];
      if (differs == 0) continue;
      const int begin = static_cast<int>(w) * 64;
      window = united(window, {.first = {.x = begin + std::countr_zero(differs), .y = y},
                               .last = {.x = begin + 63 - std::countl_zero(differs), .y = y}});
    }
  }
  return window;
}

Goal goal_inside(const BodyClearance& clearance, const Pose2& pose, const Goal& goal) {
  const GridFrame& frame = clearance.obstacles().frame();
  const double needed = clearance.body().circumscribed_radius() + 2.0 * frame.resolution;  // [m]
  const Vector2d cell = frame.to_grid(goal.position);
  const double reserve = needed / frame.resolution;
  if (cell.minCoeff() > reserve && cell.x() < frame.width - reserve &&
      cell.y() < frame.height - reserve)
    return goal;
  const GoalDistance from(clearance, pose.position);
  constexpr int kApart = 6;          // cells between candidates
  constexpr double kProgress = 0.9;  // of the path to a candidate counts, so that far ones win
  Goal best{.position = pose.position, .heading = {}};
  double least = (goal.position - pose.position).norm();
  for (int y = 0; y < frame.height; y += kApart) {
    for (int x = 0; x < frame.width; x += kApart) {
      if (clearance.distances().at({.x = x, .y = y}) < needed) continue;
      const Vector2d center = frame.center({.x = x, .y = y});
      const double cost = kProgress * from.at(center) + (goal.position - center).norm();
      if (!(cost < least)) continue;
      least = cost;
      best.position = center;
    }
  }
  return best;
}

}  // namespace fairway
