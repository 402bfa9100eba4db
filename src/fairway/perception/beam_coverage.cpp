// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/beam_coverage.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

using Eigen::Vector2d;

double covered_by_neighbours(std::span<const Beam> beams, std::size_t i, double cell) noexcept {
  constexpr std::size_t kFurthest = 8;
  constexpr double kApart = 0.9;  // [cells]; the remainder allows for the sensor's motion
  const std::size_t b = i & (~i + 1);
  if (b == 0 || b > kFurthest || i + b >= beams.size()) return 0.0;
  const Beam& left = beams[i - b];
  const Beam& right = beams[i + b];
  if (left.end == BeamEnd::Nothing || right.end == BeamEnd::Nothing) return 0.0;
  if ((left.from - right.from).norm() > 0.1 * cell) return 0.0;
  const Vector2d l = left.to - left.from;
  const Vector2d r = right.to - right.from;
  const Vector2d m = beams[i].to - beams[i].from;
  const auto cross = [](const Vector2d& p, const Vector2d& q) {
    return p.x() * q.y() - p.y() * q.x();
  };
  const double turn = cross(l, r);
  const bool between = turn * cross(l, m) > 0.0 && turn * cross(m, r) > 0.0;
  if (!between || !(l.dot(r) > 0.0) || !(l.dot(m) > 0.0)) return 0.0;
  const double apart_at_one = std::abs(turn) / (l.norm() * r.norm());  // [m] at a length of 1 m
  const double shorter = std::min(l.norm(), r.norm());
  return std::max(0.0, std::min(kApart * cell / apart_at_one, shorter - 2.0 * cell));
}

}  // namespace fairway
