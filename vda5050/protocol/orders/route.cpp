// SPDX-License-Identifier: Apache-2.0
#include "protocol/orders/route.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fairway::vda5050 {

namespace {

using Line = std::vector<Eigen::Vector2d>;

constexpr double kChord = 0.25;     // of polylines of trajectories [m]
constexpr double kSagitta = 0.002;  // [m]

// Removes points that repeat, and keeps the last one.
Line without_repeats(Line line) {
  Line kept{line.front()};
  for (const Eigen::Vector2d& point : line) {
    constexpr double kLeast = 1e-6;  // [m]
    if ((point - kept.back()).norm() > kLeast) kept.push_back(point);
  }
  if (kept.size() == 1) kept.push_back(line.back());
  return kept;
}

Strip strip_of(const Corridor& corridor) {
  return {.left = corridor.left, .right = corridor.right, .contour = corridor.contour};
}

}  // namespace

LinePoint nearest_on(const Line& line, const Eigen::Vector2d& point) {
  LinePoint nearest{.distance = (point - line.front()).norm()};
  double least = std::numeric_limits<double>::infinity();
  double arc = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d chord = line[i] - line[i - 1];
    const double length = chord.norm();
    if (!(length > 0.0)) continue;
    const Eigen::Vector2d along = chord / length;
    const Eigen::Vector2d from = point - line[i - 1];
    const double share = std::clamp(from.dot(along), 0.0, length);
    const double distance = (from - share * along).norm();
    if (distance < least) {
      least = distance;
      const double side = along.x() * from.y() - along.y() * from.x();
      nearest = {.arc = arc + share, .offset = side, .distance = distance, .direction = along};
    }
    arc += length;
  }
  return nearest;
}

double length_of(const Line& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += (line[i] - line[i - 1]).norm();
  return length;
}

Line with_short_chords(const Line& line) {
  Line points{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d chord = line[i] - line[i - 1];
    const int pieces = std::max(1, static_cast<int>(std::ceil(chord.norm() / kChord)));
    for (int k = 1; k <= pieces; ++k)
      points.emplace_back(line[i - 1] + static_cast<double>(k) / pieces * chord);
  }
  return points;
}

std::optional<Eigen::Vector2d> first_direction(const Line& line) {
  constexpr double kLeast = 1e-6;  // [m]
  for (std::size_t i = 1; i < line.size(); ++i) {
    if ((line[i] - line.front()).norm() > kLeast) return (line[i] - line.front()).normalized();
  }
  return std::nullopt;
}

std::optional<Eigen::Vector2d> last_direction(const Line& line) {
  constexpr double kLeast = 1e-6;  // [m]
  for (std::size_t i = line.size(); i > 1; --i) {
    if ((line.back() - line[i - 2]).norm() > kLeast)
      return (line.back() - line[i - 2]).normalized();
  }
  return std::nullopt;
}

double reach_of(const NodeDeviation& deviation) noexcept {
  return std::max(deviation.a, deviation.b);
}

NodeDeviation used_deviation(const NodeDeviation& given) noexcept {
  constexpr double kLeast = 0.02;  // [m]
  NodeDeviation used = given;
  if (!(reach_of(given) > 0.0)) return {.a = kOwnDeviation, .b = kOwnDeviation, .theta = 0.0};
  used.a = std::max(used.a, kLeast);
  used.b = std::max(used.b, kLeast);
  return used;
}

double ellipse_distance(const NodePosition& node, const Eigen::Vector2d& point) {
  const NodeDeviation used = used_deviation(node.deviation);
  const Eigen::Vector2d local = rotated(point - node.position, -used.theta);
  return std::hypot(local.x() / used.a, local.y() / used.b);
}

double outside_by(const RouteLeg& leg, const Eigen::Vector2d& point, double body) {
  if (!leg.strip) return 0.0;
  const LinePoint near = nearest_on(leg.line, point);
  const double reserve = leg.strip->contour ? body : 0.0;
  const auto along_end = [&](const Eigen::Vector2d& end,
                             const std::optional<Eigen::Vector2d>& out) {
    return out ? (point - end).dot(*out) : 0.0;
  };
  const std::optional<Eigen::Vector2d> first = first_direction(leg.line);
  const std::optional<Eigen::Vector2d> last = last_direction(leg.line);
  const double before = first ? along_end(leg.line.front(), Eigen::Vector2d(-*first)) : 0.0;
  const double after = along_end(leg.line.back(), last);
  // Beyond an end the strip continues straight; there the offset is square to the end's direction.
  const double side =
      near.offset >= 0.0 ? near.offset - leg.strip->left : -near.offset - leg.strip->right;
  double outside = std::max(0.0, side + reserve);
  const double length = length_of(leg.line);
  if (near.arc <= 0.0 && before > 0.0)
    outside = std::max(outside, before - reach_of(used_deviation(leg.start.deviation)));
  if (near.arc >= length && after > 0.0)
    outside = std::max(outside, after - reach_of(used_deviation(leg.end.deviation)));
  return outside;
}

std::vector<RouteLeg> legs_of(const NodePosition& before,
                              const std::vector<OrderNode>& nodes,
                              const std::vector<OrderEdge>& edges) {
  std::vector<RouteLeg> legs;
  legs.reserve(edges.size());
  const NodePosition* start = &before;
  for (std::size_t i = 0; i < edges.size() && i < nodes.size(); ++i) {
    const OrderEdge& edge = edges[i];
    RouteLeg leg{.edge_id = edge.id,
                 .edge_sequence = edge.sequence,
                 .end_node_id = nodes[i].id,
                 .start = *start,
                 .end = nodes[i].place,
                 .line = {}};
    leg.speed_max = edge.speed_max;
    leg.line_is_given = edge.trajectory.has_value();
    leg.line = without_repeats(edge.trajectory ? edge.trajectory->polyline(kChord, kSagitta)
                                               : Line{start->position, nodes[i].place.position});
    if (edge.corridor) {
      leg.strip = strip_of(*edge.corridor);
    } else if (edge.trajectory) {
      leg.strip = Strip{.left = kLineTolerance, .right = kLineTolerance};
    }
    legs.push_back(std::move(leg));
    start = &nodes[i].place;
  }
  return legs;
}

}  // namespace fairway::vda5050
