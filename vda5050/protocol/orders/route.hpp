// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fairway/geometry/pose2.hpp"
#include "protocol/messages/order.hpp"

namespace fairway::vda5050 {

/// The strip in which a vehicle must stay on a leg, left and right of the leg's line as seen in the
/// direction of travel.
struct Strip {
  double left = 0.0;     ///< [m]
  double right = 0.0;    ///< [m]
  bool contour = false;  ///< the whole body stays inside; otherwise its reference point
};

/// One edge of an order with the geometry that a driver needs.
struct RouteLeg {
  std::string edge_id;
  std::uint32_t edge_sequence = 0;
  std::string end_node_id;
  NodePosition start;                 ///< node at which it begins
  NodePosition end;                   ///< node at which it ends
  std::vector<Eigen::Vector2d> line;  ///< from the first to the last node, at least two points [m]
  std::optional<Strip> strip{};       ///< none: the vehicle chooses its own path
  bool line_is_given = false;         ///< by a trajectory
  std::optional<double> speed_max{};  ///< [m/s]
  bool returns = false;  ///< the leave has ended: the vehicle goes back to the line and waits
};

/// Where the vehicle drives now: the legs up to the node at which it must stop.
struct Route {
  std::vector<RouteLeg> legs;
  std::optional<double> heading{};  ///< at the end [rad]
};

/// A point of a line.
struct LinePoint {
  double arc = 0.0;       ///< from the beginning of the line [m]
  double offset = 0.0;    ///< of the queried point, positive to the left [m]
  double distance = 0.0;  ///< of the queried point [m]
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< of travel
};

/// Returns the point of a line nearest to `point`. @pre the line has a point.
[[nodiscard]] LinePoint nearest_on(const std::vector<Eigen::Vector2d>& line,
                                   const Eigen::Vector2d& point);

[[nodiscard]] double length_of(const std::vector<Eigen::Vector2d>& line);

/// The same line with more points, so that no chord is longer than 0.25 m.
[[nodiscard]] std::vector<Eigen::Vector2d> with_short_chords(
    const std::vector<Eigen::Vector2d>& line);

/// Direction of travel at the beginning and at the end of a line; none for a line without length.
[[nodiscard]] std::optional<Eigen::Vector2d> first_direction(
    const std::vector<Eigen::Vector2d>& line);
[[nodiscard]] std::optional<Eigen::Vector2d> last_direction(
    const std::vector<Eigen::Vector2d>& line);

/// How far a point is outside a leg's strip, which is extended straight beyond both ends by the
/// deviation of the nodes [m]; 0 inside, and for a leg without a strip.
/// @param body  Distance from the point to the outline of the body, for a strip of the contour [m].
[[nodiscard]] double outside_by(const RouteLeg& leg, const Eigen::Vector2d& point, double body);

/// The greatest distance from a node at which it can be passed [m].
[[nodiscard]] double reach_of(const NodeDeviation& deviation) noexcept;

/// The deviation that a vehicle uses: its own where the order leaves it open.
[[nodiscard]] NodeDeviation used_deviation(const NodeDeviation& given) noexcept;

/// Distance from a node in units of its ellipse: at most 1 inside.
[[nodiscard]] double ellipse_distance(const NodePosition& node, const Eigen::Vector2d& point);

/// The legs of an order, from the first node on.
/// @param before  Place of the node at which the first edge begins.
[[nodiscard]] std::vector<RouteLeg> legs_of(const NodePosition& before,
                                            const std::vector<OrderNode>& nodes,
                                            const std::vector<OrderEdge>& edges);

/// Own tolerance about a trajectory that has no corridor [m].
inline constexpr double kLineTolerance = 0.15;

/// Own deviation at nodes where the order gives none [m].
inline constexpr double kOwnDeviation = 0.25;

}  // namespace fairway::vda5050
