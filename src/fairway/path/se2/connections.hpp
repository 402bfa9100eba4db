// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/path/se2/motion_path.hpp"

namespace fairway {

/// One way from a pose to another, without regard to obstacles.
struct Connection {
  std::vector<MotionPiece> pieces;
  double cost = 0.0;  ///< by MotionCost [s]
};

/// Returns the analytic connections between two poses that a base can drive, least cost first.
///
/// Steered bases: the Reeds-Shepp words of the turning radius and of wider ones. Unicycles: turn,
/// drive, turn, forwards and backwards. Omnidirectional bases: one constant twist; line and turn in
/// both orders. All end exactly at `to`.
void find_connections(const MotionCost& cost,
                      const Pose2& from,
                      const Pose2& to,
                      std::vector<Connection>& found);

/// A lower bound of the cost of any motion from `from` to `to`, without obstacles [s].
[[nodiscard]] double least_cost(const MotionCost& cost,
                                const Pose2& from,
                                const Pose2& to) noexcept;

/// Returns the curvature of the tightest arcs that a search drives [1/m]. It is slightly below the
/// greatest, so that a controller can still correct. Steered bases only.
[[nodiscard]] double search_curvature(const BaseModel& base) noexcept;

}  // namespace fairway
