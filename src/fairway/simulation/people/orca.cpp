// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/people/orca.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kParallel = 1e-5;  // sine of the angle below which lines count as parallel

double cross(const Vector2d& a, const Vector2d& b) noexcept {
  return a.x() * b.y() - a.y() * b.x();
}

// The velocities to the left of a directed line are allowed.
struct HalfPlane {
  Vector2d point;
  Vector2d direction;

  // How far `velocity` is on the forbidden side [m/s]; negative on the allowed one.
  [[nodiscard]] double violation(const Vector2d& velocity) const noexcept {
    return cross(direction, point - velocity);
  }
};

// A linear objective takes the furthest velocity in direction `wanted`, the other one the velocity
// nearest to `wanted`.
struct Objective {
  Vector2d wanted;
  bool is_linear = false;
};

HalfPlane half_plane(const OrcaAgent& agent,
                     const OrcaNeighbour& other,
                     const OrcaSettings& settings) noexcept {
  const Vector2d apart = other.position - agent.position;
  const Vector2d relative = agent.velocity - other.velocity;
  const double radius = agent.radius + other.radius;
  const double distance2 = apart.squaredNorm();
  const bool touches = distance2 <= radius * radius;
  const double horizon = touches ? settings.step : settings.horizon;
  const Vector2d from_cap = relative - apart / horizon;
  const double along = from_cap.dot(apart);
  HalfPlane plane;
  Vector2d change;
  if (touches || (along < 0.0 && along * along > radius * radius * from_cap.squaredNorm())) {
    const double length = from_cap.norm();
    const Vector2d normal = length > 0.0 ? Vector2d(from_cap / length) : Vector2d::UnitX();
    plane.direction = {normal.y(), -normal.x()};
    change = (radius / horizon - length) * normal;
  } else {
    const double leg = std::sqrt(distance2 - radius * radius);
    const double side = cross(apart, from_cap) > 0.0 ? 1.0 : -1.0;
    plane.direction = side *
                      Vector2d(apart.x() * leg - side * apart.y() * radius,
                               side * apart.x() * radius + apart.y() * leg) /
                      distance2;
    change = relative.dot(plane.direction) * plane.direction - relative;
  }
  plane.point = agent.velocity + 0.5 * change;
  return plane;
}

// The best velocity on line `index`, within the disc and the half-planes before it.
std::optional<Vector2d> best_on_line(std::span<const HalfPlane> planes,
                                     std::size_t index,
                                     double speed_max,
                                     const Objective& objective) noexcept {
  const auto& [point, direction] = planes[index];
  const double middle = point.dot(direction);
  const double inside = middle * middle + speed_max * speed_max - point.squaredNorm();
  if (inside < 0.0) return std::nullopt;
  double low = -middle - std::sqrt(inside);
  double high = -middle + std::sqrt(inside);
  for (std::size_t i = 0; i < index; ++i) {
    const double sine = cross(direction, planes[i].direction);
    const double distance = cross(planes[i].direction, point - planes[i].point);
    if (std::abs(sine) <= kParallel) {
      if (distance < 0.0) return std::nullopt;
      continue;
    }
    (sine >= 0.0 ? high : low) =
        sine >= 0.0 ? std::min(high, distance / sine) : std::max(low, distance / sine);
    if (low > high) return std::nullopt;
  }
  const double along = objective.is_linear
                           ? (objective.wanted.dot(direction) > 0.0 ? high : low)
                           : std::clamp(direction.dot(objective.wanted - point), low, high);
  return point + along * direction;
}

// Adds the half-planes one by one. @return the first that leaves nothing, and the best velocity
// before it; the number of half-planes if all can be kept.
std::pair<std::size_t, Vector2d> best_velocity(std::span<const HalfPlane> planes,
                                               double speed_max,
                                               const Objective& objective) noexcept {
  Vector2d best = objective.wanted;
  if (objective.is_linear) {
    best *= speed_max;
  } else if (best.squaredNorm() > speed_max * speed_max) {
    best = best.normalized() * speed_max;
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (!(planes[i].violation(best) > 0.0)) continue;
    const std::optional<Vector2d> next = best_on_line(planes, i, speed_max, objective);
    if (!next) return {i, best};
    best = *next;
  }
  return {planes.size(), best};
}

// The velocities that violate `a` and `b` equally are the border of the result.
std::optional<HalfPlane> equal_violation(const HalfPlane& a, const HalfPlane& b) noexcept {
  const double sine = cross(a.direction, b.direction);
  HalfPlane border;
  if (std::abs(sine) > kParallel) {
    border.point = a.point + cross(b.direction, a.point - b.point) / sine * a.direction;
  } else if (a.direction.dot(b.direction) > 0.0) {
    return std::nullopt;
  } else {
    border.point = 0.5 * (a.point + b.point);
  }
  border.direction = (b.direction - a.direction).normalized();
  return border;
}

Vector2d least_violation(std::span<const HalfPlane> planes,
                         std::size_t first,
                         double speed_max,
                         Vector2d velocity) {
  double violation = 0.0;
  std::vector<HalfPlane> borders;
  for (std::size_t i = first; i < planes.size(); ++i) {
    if (!(planes[i].violation(velocity) > violation)) continue;
    borders.clear();
    for (std::size_t j = 0; j < i; ++j) {
      if (const std::optional<HalfPlane> border = equal_violation(planes[i], planes[j]))
        borders.push_back(*border);
    }
    const Vector2d inwards(-planes[i].direction.y(), planes[i].direction.x());
    const auto [kept, best] =
        best_velocity(borders, speed_max, {.wanted = inwards, .is_linear = true});
    if (kept == borders.size()) velocity = best;
    violation = planes[i].violation(velocity);
  }
  return velocity;
}

}  // namespace

Vector2d orca_velocity(const OrcaAgent& agent,
                       std::span<const OrcaNeighbour> neighbours,
                       const OrcaSettings& settings) {
  std::vector<std::pair<double, const OrcaNeighbour*>> near;
  const double range2 = settings.neighbour_distance * settings.neighbour_distance;
  for (const OrcaNeighbour& other : neighbours) {
    const double distance2 = (other.position - agent.position).squaredNorm();
    if (distance2 < range2) near.emplace_back(distance2, &other);
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  near.resize(std::min(near.size(), settings.neighbours_max));
  std::vector<HalfPlane> planes;
  for (const auto& [distance2, other] : near)
    planes.push_back(half_plane(agent, *other, settings));
  const auto [kept, velocity] = best_velocity(planes, agent.speed_max, {.wanted = agent.preferred});
  return kept == planes.size() ? velocity
                               : least_violation(planes, kept, agent.speed_max, velocity);
}

}  // namespace fairway
