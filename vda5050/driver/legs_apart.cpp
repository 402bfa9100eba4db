// SPDX-License-Identifier: Apache-2.0
#include "driver/legs_apart.hpp"

#include <algorithm>
#include <cmath>

#include "driver/leg_strips.hpp"

namespace fairway::vda5050 {

namespace {

using Point = Eigen::Vector2d;
using Polygon = std::vector<Point>;

// Whether an edge of the convex polygon `a` separates it from `b`.
bool separates(const Polygon& a, const Polygon& b) {
  Point middle = Point::Zero();
  for (const Point& corner : a)
    middle += corner / static_cast<double>(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point edge = a[(i + 1) % a.size()] - a[i];
    Point normal(-edge.y(), edge.x());
    if ((middle - a[i]).dot(normal) > 0.0) normal = -normal;
    if (std::all_of(b.begin(), b.end(),
                    [&](const Point& corner) { return (corner - a[i]).dot(normal) > 0.0; })) {
      return true;
    }
  }
  return false;
}

bool meet(const Polygon& a, const Polygon& b) {
  constexpr std::size_t kLeast = 3;
  return a.size() >= kLeast && b.size() >= kLeast && !separates(a, b) && !separates(b, a);
}

// The strips of a leg: whole, and clipped at its joints.
struct LegStrips {
  Zones whole;
  Zones clipped;
};

bool any_meets(const Zones& strips, const Polygon& polygon) {
  return std::any_of(strips.begin(), strips.end(),
                     [&](const fairway::Zone& strip) { return meet(strip.polygon, polygon); });
}

// How far the part of the line to which a strip belongs is beyond the plane of a joint.
double beyond(const RouteLeg& leg, const Polygon& strip, const StripJoint& joint) {
  Point middle = Point::Zero();
  for (const Point& corner : strip)
    middle += corner / static_cast<double>(strip.size());
  const LinePoint near = nearest_on(leg.line, middle);
  Point foot = middle - near.offset * Point(-near.direction.y(), near.direction.x());
  if (near.arc <= 0.0) foot = leg.line.front();
  if (near.arc >= length_of(leg.line)) foot = leg.line.back();
  return (foot - joint.node).dot(joint.along);
}

constexpr double kBeyond = 0.02;  // of a line that bends over the plane of its joint [m]

// Whether a strip of the next leg meets those of its neighbour elsewhere than at their joint.
bool meets_beside(const RouteLeg& leg,
                  const LegStrips& strips,
                  const Polygon& of_next,
                  const StripJoint& joint) {
  constexpr double kSlack = 0.005;  // [m]
  const Point& along = joint.along;
  const Polygon back = clipped(of_next, joint.node - (joint.before + kSlack) * along, along);
  for (const fairway::Zone& strip : strips.clipped) {
    const Polygon ahead =
        clipped(strip.polygon, joint.node + (joint.after + kSlack) * along, -along);
    if (meet(strip.polygon, back) || meet(ahead, of_next)) return true;
  }
  return std::any_of(strips.whole.begin(), strips.whole.end(), [&](const fairway::Zone& strip) {
    return beyond(leg, strip.polygon, joint) > kBeyond && meet(strip.polygon, of_next);
  });
}

// The length of line that is left before one of the strips meets another one.
template <typename Meets>
double length_before(const RouteLeg& leg, const Zones& strips, Meets&& meets) {
  double least = length_of(leg.line);
  for (const fairway::Zone& strip : strips) {
    if (!meets(strip.polygon)) continue;
    for (const Point& corner : strip.polygon)
      least = std::min(least, nearest_on(leg.line, corner).arc);
  }
  return least;
}

void cut_leg(double length, RouteLeg& leg) {
  std::vector<Point> line{leg.line.front()};
  double arc = 0.0;
  for (std::size_t i = 1; i < leg.line.size(); ++i) {
    const Point chord = leg.line[i] - leg.line[i - 1];
    const double whole = chord.norm();
    if (whole > 0.0)
      line.emplace_back(leg.line[i - 1] + std::min(1.0, (length - arc) / whole) * chord);
    arc += whole;
    if (arc >= length) break;
  }
  leg.line = std::move(line);
  constexpr double kAtCut = 0.05;  // [m]
  leg.end = {.position = leg.line.back(), .deviation = {.a = kAtCut, .b = kAtCut}};
}

}  // namespace

LegsApart legs_apart(std::span<const RouteLeg> legs, const Zones& behind, double body) {
  constexpr double kShortest = 0.4;  // of a leg that is cut [m]
  constexpr double kBefore = 0.1;    // from the cut to the place that it avoids [m]
  LegsApart apart;
  std::vector<RouteLeg> fine(legs.begin(), legs.end());
  for (RouteLeg& leg : fine)
    leg.line = with_short_chords(leg.line);
  const auto joints = joints_of(fine, nullptr, body);
  std::vector<LegStrips> strips;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const RouteLeg& leg = fine[i];
    const double after = reach_of(used_deviation(leg.end.deviation));
    strips.push_back({.whole = strips_of(leg, std::nullopt, std::nullopt, after),
                      .clipped = strips_of(leg, joints[i], joints[i + 1], after)});
    apart.legs.push_back(legs[i]);
    if (i == 0) continue;
    const auto meets = [&](const Polygon& polygon) {
      if (any_meets(behind, polygon)) return true;
      for (std::size_t k = 0; k < i; ++k) {
        const bool at_joint = k + 1 == i && joints[i];
        if (at_joint ? meets_beside(fine[k], strips[k], polygon, *joints[i])
                     : any_meets(strips[k].clipped, polygon)) {
          return true;
        }
      }
      return false;
    };
    const auto bends_back = [&](const Polygon& polygon) {
      return joints[i] && beyond(leg, polygon, *joints[i]) < -kBeyond &&
             any_meets(strips[i - 1].clipped, polygon);
    };
    const double whole = length_of(leg.line);
    const double left = std::min(length_before(leg, strips[i].clipped, meets),
                                 length_before(leg, strips[i].whole, bends_back));
    if (left >= whole) continue;
    apart.cut = true;
    if (left - kBefore < kShortest) {
      apart.legs.pop_back();
      apart.stop = i == 1;
    } else {
      cut_leg(left - kBefore, apart.legs.back());
    }
    break;
  }
  return apart;
}

}  // namespace fairway::vda5050
