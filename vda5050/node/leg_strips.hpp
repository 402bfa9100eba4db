// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

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

/// Clips the strips of a leg near its joints.
void clip_strips(const RouteLeg& leg,
                 const std::optional<StripJoint>& start,
                 const std::optional<StripJoint>& end,
                 Zones& strips);

/// Walls on both sides of the node at the end of a leg, so that the reference point passes the node
/// within its deviation.
/// @param reach  Length of the walls from the node on [m].
void add_gate(const RouteLeg& leg, const StripJoint& joint, double reach, Zones& area);

}  // namespace fairway::vda5050
