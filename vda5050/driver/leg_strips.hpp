// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fairway/zones/zones.hpp"
#include "protocol/orders/route.hpp"

namespace fairway::vda5050 {

/// The strip of a leg as convex polygons: a rectangle per chord of its line, extended straight at
/// both ends, and a wedge at the outside of each bend.
/// @param before, after  Lengths of the extensions [m].
void add_strip(const RouteLeg& leg, double before, double after, Zones& area);

/// Where the strips of a leg meet those of the next one: in the plane through the node that halves
/// the turn. So the robot is always inside the strip of the leg that it is on. If only one of the
/// two is for the contour, it reaches over the plane by the body.
struct StripJoint {
  Eigen::Vector2d node = Eigen::Vector2d::Zero();
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();  ///< of travel, square to the plane
  double before = 0.0;  ///< how far the strips of the next leg reach back over the plane [m]
  double after = 0.0;   ///< how far those of the leg reach over it [m]
};

/// Returns the joint; none where the legs do not meet, turn back, or have no strip.
/// @param body  Radius of the disc that covers the robot [m].
[[nodiscard]] std::optional<StripJoint> joint_of(const RouteLeg& leg,
                                                 const RouteLeg& next,
                                                 double body);

/// The joints of legs: the one with number i is at the beginning of leg i.
/// @param behind  The leg before the first one; may be null.
[[nodiscard]] std::vector<std::optional<StripJoint>> joints_of(std::span<const RouteLeg> legs,
                                                               const RouteLeg* behind,
                                                               double body);

/// The strips of a leg, clipped near its joints.
/// @param after  How far they extend beyond an end without a joint [m].
[[nodiscard]] Zones strips_of(const RouteLeg& leg,
                              const std::optional<StripJoint>& start,
                              const std::optional<StripJoint>& end,
                              double after);

/// How far a strip extends behind the end at which a robot stops: enough for its tolerance [m].
[[nodiscard]] double end_extension(const NodeDeviation& deviation);

/// Keeps of the strips only the part within about `reach` of a point, for the reference point or
/// for the body.
/// @param body  Radius of the disc that covers the robot [m].
void keep_near(const Eigen::Vector2d& point, double reach, double body, Zones& strips);

/// The part of a convex polygon on the side of a line against `normal`; may be empty.
[[nodiscard]] std::vector<Eigen::Vector2d> clipped(const std::vector<Eigen::Vector2d>& polygon,
                                                   const Eigen::Vector2d& on,
                                                   const Eigen::Vector2d& normal);

/// Walls on both sides of the node at the end of a leg, as long as the strips of both legs meet, so
/// that the reference point passes the node within its deviation.
void add_gate(const RouteLeg& leg,
              const StripJoint& joint,
              const Zones& of_leg,
              const Zones& of_next,
              Zones& area);

}  // namespace fairway::vda5050
