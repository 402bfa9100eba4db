// SPDX-License-Identifier: Apache-2.0
#include "protocol/orders/node_passing.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/geometry/angle.hpp"

namespace fairway::vda5050 {

namespace {

// Least distance from the node to the line between two points, in units of the ellipse.
double swept_distance(const NodePosition& node,
                      const Eigen::Vector2d& from,
                      const Eigen::Vector2d& to) {
  const NodeDeviation used = used_deviation(node.deviation);
  const auto scaled = [&](const Eigen::Vector2d& point) {
    const Eigen::Vector2d local = rotated(point - node.position, -used.theta);
    return Eigen::Vector2d(local.x() / used.a, local.y() / used.b);
  };
  const Eigen::Vector2d a = scaled(from);
  const Eigen::Vector2d line = scaled(to) - a;
  const double squared = line.squaredNorm();
  const double share = squared > 0.0 ? std::clamp(-a.dot(line) / squared, 0.0, 1.0) : 0.0;
  return (a + share * line).norm();
}

// The direction in which the node between two legs is crossed; none where they turn back.
std::optional<Eigen::Vector2d> crossing(const RouteLeg& leg, const RouteLeg* next) {
  const std::optional<Eigen::Vector2d> in = last_direction(leg.line);
  const std::optional<Eigen::Vector2d> out = next != nullptr ? first_direction(next->line) : in;
  if (!in || !out) return in ? in : out;
  const Eigen::Vector2d sum = *in + *out;
  constexpr double kLeast = 0.2;
  return sum.norm() > kLeast ? std::optional<Eigen::Vector2d>(sum.normalized()) : std::nullopt;
}

}  // namespace

bool NodePassing::passes(const RouteLeg& leg,
                         const RouteLeg* next,
                         const Eigen::Vector2d& before,
                         const Eigen::Vector2d& now,
                         double body) {
  was_inside_ = was_inside_ || swept_distance(leg.end, before, now) <= 1.0;
  if (!was_inside_) return false;
  if (next != nullptr) {
    constexpr double kSlack = 0.02;  // [m]
    if (outside_by(*next, now, body) > kSlack) return false;
  }
  const std::optional<Eigen::Vector2d> direction = crossing(leg, next);
  if (!direction) return true;
  return (now - leg.end.position).dot(*direction) >= 0.0 || ellipse_distance(leg.end, now) > 1.0;
}

bool is_at(const NodePosition& node, const Pose2& pose, double slack) {
  const NodeDeviation used = used_deviation(node.deviation);
  NodePosition wider = node;
  wider.deviation = {.a = used.a + slack, .b = used.b + slack, .theta = used.theta};
  if (ellipse_distance(wider, pose.position) > 1.0) return false;
  if (!node.theta) return true;
  constexpr double kSlack = 0.02;  // [rad]
  const double allowed = node.theta_deviation > 0.0 ? node.theta_deviation : kOwnHeadingDeviation;
  return std::abs(shortest_turn(*node.theta, pose.heading)) <= allowed + kSlack;
}

bool needs_stop(const RouteLeg& leg, const RouteLeg& next) {
  constexpr double kSmallest = 0.12;  // ellipse that can be met on the way [m]
  constexpr double kSharpest = -0.5;  // cosine of the turn: more than 120 degrees
  const NodeDeviation used = used_deviation(leg.end.deviation);
  if (std::min(used.a, used.b) < kSmallest) return true;
  const std::optional<Eigen::Vector2d> in = last_direction(leg.line);
  const std::optional<Eigen::Vector2d> out = first_direction(next.line);
  if (!in || !out || in->dot(*out) < kSharpest) return true;
  if (!leg.end.theta) return false;
  // A heading along the lanes is met on the way.
  const double allowed =
      leg.end.theta_deviation > 0.0 ? leg.end.theta_deviation : kOwnHeadingDeviation;
  const auto off = [&](const Eigen::Vector2d& travel) {
    return std::abs(shortest_turn(*leg.end.theta, std::atan2(travel.y(), travel.x())));
  };
  constexpr double kShare = 0.5;
  return std::max(off(*in), off(*out)) > kShare * allowed;
}

}  // namespace fairway::vda5050
