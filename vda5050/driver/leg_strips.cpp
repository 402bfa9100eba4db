// SPDX-License-Identifier: Apache-2.0
#include "driver/leg_strips.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "fairway/geometry/pose2.hpp"

namespace fairway::vda5050 {

namespace {

using Point = Eigen::Vector2d;

Point left_of(const Point& direction) { return {-direction.y(), direction.x()}; }

// How far strips reach along the plane of a joint: to its right, as a negative number, and left.
struct Reach {
  double right = 0.0;  // [m]
  double left = 0.0;   // [m]
};

Reach reach_at(const StripJoint& joint, const Zones& strips) {
  constexpr double kNear = 0.01;  // beyond the place where both legs have strips [m]
  Reach reach;
  for (const fairway::Zone& strip : strips) {
    const Point first = joint.node - (joint.before + kNear) * joint.along;
    const Point last = joint.node + (joint.after + kNear) * joint.along;
    const auto part = clipped(clipped(strip.polygon, last, joint.along), first, -joint.along);
    for (const Point& corner : part) {
      const double side = (corner - joint.node).dot(left_of(joint.along));
      reach.right = std::min(reach.right, side);
      reach.left = std::max(reach.left, side);
    }
  }
  return reach;
}

// Clips the strips of a leg that lie near its joints.
void clip_strips(const RouteLeg& leg,
                 const std::optional<StripJoint>& start,
                 const std::optional<StripJoint>& end,
                 Zones& strips) {
  const double width = 2.0 * std::max(leg.strip->left, leg.strip->right);
  const double near_start = width + reach_of(used_deviation(leg.start.deviation));
  const double near_end = width + reach_of(used_deviation(leg.end.deviation));
  const double length = length_of(leg.line);
  std::erase_if(strips, [&](fairway::Zone& strip) {
    Point middle = Point::Zero();
    for (const Point& corner : strip.polygon)
      middle += corner / static_cast<double>(strip.polygon.size());
    const double arc = nearest_on(leg.line, middle).arc;
    const bool whole = leg.line.size() == 2;
    if (end && (whole || length - arc < near_end))
      strip.polygon = clipped(strip.polygon, end->node + end->after * end->along, end->along);
    if (start && (whole || arc < near_start))
      strip.polygon =
          clipped(strip.polygon, start->node - start->before * start->along, -start->along);
    return find_fault(strip).has_value();
  });
}

}  // namespace

std::vector<Point> clipped(const std::vector<Point>& polygon,
                           const Point& on,
                           const Point& normal) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const double from = (a - on).dot(normal);
    const double to = (b - on).dot(normal);
    if (from <= 0.0) kept.push_back(a);
    if (from * to < 0.0) kept.push_back(a + from / (from - to) * (b - a));
  }
  return kept;
}

void add_strip(const RouteLeg& leg, double before, double after, Zones& area) {
  if (!leg.strip) return;
  constexpr double kNarrowest = 0.005;  // of a side that is a polygon at all [m]
  Strip strip = *leg.strip;
  strip.left = std::max(strip.left, kNarrowest);
  strip.right = std::max(strip.right, kNarrowest);
  const auto add = [&](std::vector<Point> polygon) {
    area.push_back({.kind = ZoneKind::Strip,
                    .polygon = std::move(polygon),
                    .reference = strip.contour ? ZoneReference::Contour : ZoneReference::Centre,
                    .name = leg.edge_id});
  };
  const std::vector<Point>& line = leg.line;
  std::optional<Point> previous;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point chord = line[i] - line[i - 1];
    const double length = chord.norm();
    if (!(length > 0.0)) continue;
    const Point along = chord / length;
    const Point left = left_of(along);
    const Point from = line[i - 1] - (previous ? 0.0 : before) * along;
    const Point to = line[i] + (i + 1 == line.size() ? after : 0.0) * along;
    add({from - strip.right * left, to - strip.right * left, to + strip.left * left,
         from + strip.left * left});
    if (previous) {
      // The wedge between two chords, on the outside of the bend.
      const double turn = previous->x() * along.y() - previous->y() * along.x();
      const double width = turn > 0.0 ? -strip.right : strip.left;
      // Without the wedge of a slighter bend the gap is below 1e-6 m.
      constexpr double kLeastArea = 1e-7;  // [m^2]
      if (0.5 * width * width * std::abs(turn) > kLeastArea)
        add({line[i - 1], line[i - 1] + width * left_of(*previous), line[i - 1] + width * left});
    }
    previous = along;
  }
  if (previous) return;
  // A turn on the spot.
  const double half = std::max({strip.left, strip.right, before, after});
  const Point& here = line.front();
  add({here + Point(-half, -half), here + Point(half, -half), here + Point(half, half),
       here + Point(-half, half)});
}

std::optional<StripJoint> joint_of(const RouteLeg& leg, const RouteLeg& next, double body) {
  const std::optional<Point> in = last_direction(leg.line);
  const std::optional<Point> out = first_direction(next.line);
  constexpr double kSame = 1e-6;  // [m]
  const bool meet = (leg.end.position - next.start.position).norm() < kSame;
  if (!leg.strip || !next.strip || !in || !out || !meet) return std::nullopt;
  constexpr double kTurnsBack = 0.5;
  const Point sum = *in + *out;
  if (sum.norm() < kTurnsBack) return std::nullopt;
  constexpr double kSeam = 0.002;  // [m]
  const double reach = body + 0.05;
  const bool mixed = leg.strip->contour != next.strip->contour;
  return StripJoint{.node = leg.end.position,
                    .along = sum.normalized(),
                    .before = mixed && next.strip->contour ? reach : kSeam,
                    .after = mixed && leg.strip->contour ? reach : kSeam};
}

std::vector<std::optional<StripJoint>> joints_of(std::span<const RouteLeg> legs,
                                                 const RouteLeg* behind,
                                                 double body) {
  std::vector<std::optional<StripJoint>> joints(legs.size() + 1);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const RouteLeg* before = i > 0 ? &legs[i - 1] : behind;
    if (before != nullptr) joints[i] = joint_of(*before, legs[i], body);
  }
  return joints;
}

Zones strips_of(const RouteLeg& leg,
                const std::optional<StripJoint>& start,
                const std::optional<StripJoint>& end,
                double after) {
  Zones strips;
  add_strip(leg, reach_of(used_deviation(leg.start.deviation)), after, strips);
  if (leg.strip) clip_strips(leg, start, end, strips);
  return strips;
}

double end_extension(const NodeDeviation& deviation) {
  constexpr double kMost = 0.3;  // [m]
  return std::min(reach_of(used_deviation(deviation)), kMost);
}

void keep_near(const Point& point, double reach, double body, Zones& strips) {
  constexpr int kSides = 16;
  std::erase_if(strips, [&](fairway::Zone& strip) {
    const double far = reach + (strip.reference == ZoneReference::Contour ? body : 0.0);
    for (int i = 0; i < kSides; ++i) {
      const Point side = direction(2.0 * std::numbers::pi * i / kSides);
      strip.polygon = clipped(strip.polygon, point + far * side, side);
    }
    return find_fault(strip).has_value();
  });
}

void add_gate(const RouteLeg& leg,
              const StripJoint& joint,
              const Zones& of_leg,
              const Zones& of_next,
              Zones& area) {
  const Point& along = joint.along;
  const Point side = left_of(along);
  const NodeDeviation used = used_deviation(leg.end.deviation);
  // Half the width of the ellipse along the wall.
  const Point local = rotated(side, -used.theta);
  const double half = 1.0 / std::hypot(local.x() / used.a, local.y() / used.b);
  constexpr double kShortest = 0.02;  // [m]
  constexpr double kThin = 0.01;      // half the thickness of a wall [m]
  const Point& node = leg.end.position;
  const Reach a = reach_at(joint, of_leg);
  const Reach b = reach_at(joint, of_next);
  const auto add_wall = [&](double sign, double reach) {
    if (!(reach > half + kShortest)) return;
    const Point inner = node + sign * half * side;
    const Point outer = node + sign * reach * side;
    area.push_back({.kind = ZoneKind::KeepOut,
                    .polygon = {inner - kThin * along, inner + kThin * along, outer + kThin * along,
                                outer - kThin * along},
                    .reference = ZoneReference::Centre,
                    .name = leg.end_node_id});
  };
  add_wall(-1.0, -std::max(a.right, b.right));
  add_wall(1.0, std::min(a.left, b.left));
}

}  // namespace fairway::vda5050
