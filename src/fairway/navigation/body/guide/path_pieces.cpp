// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/guide/path_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fairway/geometry/angle.hpp"

namespace fairway::internal {

namespace {

using Eigen::Vector2d;

constexpr double kNoise = 0.04;  // of positions [m]

double angle_of(const Vector2d& line) noexcept { return std::atan2(line.y(), line.x()); }

double distance_from(const Vector2d& point, const Vector2d& a, const Vector2d& b) noexcept {
  const Vector2d line = b - a;
  const double square = line.squaredNorm();
  const double share = square > 0.0 ? std::clamp(line.dot(point - a) / square, 0.0, 1.0) : 0.0;
  return (a + share * line - point).norm();
}

// The poses without which the path changes by more than noise (Douglas and Peucker), in order.
std::vector<std::size_t> corners_of(const std::vector<PathPose>& poses) {
  std::vector<std::size_t> corners{0, poses.size() - 1};
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, poses.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double most = kNoise;
    std::size_t furthest = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance =
          distance_from(poses[i].position, poses[first].position, poses[last].position);
      if (distance <= most) continue;
      most = distance;
      furthest = i;
    }
    if (furthest == first) continue;
    corners.push_back(furthest);
    open.emplace_back(first, furthest);
    open.emplace_back(furthest, last);
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

// Cosine of the angle between a heading and the path there, over some distance to both sides.
double alignment(const std::vector<PathPose>& poses, std::size_t i) noexcept {
  constexpr double kReach = 0.15;  // [m]
  std::size_t first = i;
  std::size_t last = i;
  while (first > 0 && (poses[first].position - poses[i].position).norm() < kReach)
    --first;
  while (last + 1 < poses.size() && (poses[last].position - poses[i].position).norm() < kReach)
    ++last;
  const Vector2d line = poses[last].position - poses[first].position;
  if (line.norm() < 1e-6) return 0.0;
  return std::cos(shortest_turn(angle_of(line), *poses[i].heading));
}

// Splits a piece where its headings change sides for some distance.
void split_by_headings(const PathPiece& piece, std::vector<PathPiece>& pieces) {
  constexpr double kShort = 0.15;  // of a change of sides that is noise [m]
  std::vector<int> sides;
  for (std::size_t i = 0; i < piece.poses.size(); ++i) {
    const double cosine = piece.poses[i].heading ? alignment(piece.poses, i) : 0.0;
    constexpr double kClear = 0.3;
    sides.push_back(cosine > kClear ? 1 : cosine < -kClear ? -1 : 0);
  }
  PathPiece now{.poses = {}, .gear = 0};
  for (std::size_t i = 0; i < piece.poses.size(); ++i) {
    now.poses.push_back(piece.poses[i]);
    if (sides[i] == 0 || sides[i] == now.gear) continue;
    double length = 0.0;
    std::size_t k = i;
    while (k + 1 < sides.size() && (sides[k + 1] == sides[i] || sides[k + 1] == 0)) {
      length += (piece.poses[k + 1].position - piece.poses[k].position).norm();
      ++k;
    }
    if (length < kShort && !(now.gear == 0 && k + 1 == sides.size())) continue;
    if (now.gear != 0 && now.poses.size() > 1) {
      pieces.push_back(now);
      now.poses = {piece.poses[i]};
    }
    now.gear = sides[i];
  }
  if (now.gear == 0) now.gear = 1;
  if (now.poses.size() > 1) pieces.push_back(now);
}

}  // namespace

bool headings_fit(const std::vector<PathPose>& poses) noexcept {
  int given = 0;
  int fitting = 0;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    if (!poses[i].heading) continue;
    constexpr double kNear = 0.8;
    ++given;
    fitting += std::abs(alignment(poses, i)) > kNear ? 1 : 0;
  }
  constexpr double kMost = 0.7;
  return given > 0 && fitting >= kMost * given;
}

std::vector<PathPiece> cut_path(std::vector<PathPose> poses, const BaseModel& base) {
  if (base.kind == BaseKind::Omni) return {{.poses = std::move(poses), .gear = 0}};
  const bool fit = headings_fit(poses);
  if (!fit) {
    for (std::size_t i = 0; i + 1 < poses.size(); ++i)
      poses[i].heading.reset();
  }
  const std::vector<std::size_t> corners = corners_of(poses);
  std::vector<PathPiece> found;
  PathPiece now{.poses = {poses.front()}, .gear = 1};
  const bool steered = is_steered(base);
  for (std::size_t c = 1; c < corners.size(); ++c) {
    for (std::size_t i = corners[c - 1] + 1; i <= corners[c]; ++i)
      now.poses.push_back(poses[i]);
    if (c + 1 == corners.size()) break;
    const Vector2d before = poses[corners[c]].position - poses[corners[c - 1]].position;
    const Vector2d after = poses[corners[c + 1]].position - poses[corners[c]].position;
    constexpr double kTurnsBack = 2.0;  // [rad]
    if (std::abs(shortest_turn(angle_of(before), angle_of(after))) < kTurnsBack) continue;
    found.push_back(now);
    now = {.poses = {poses[corners[c]]}, .gear = steered ? -now.gear : 1};
  }
  found.push_back(now);
  if (!fit) return found;
  std::vector<PathPiece> pieces;
  for (const PathPiece& piece : found)
    split_by_headings(piece, pieces);
  return pieces;
}

}  // namespace fairway::internal
