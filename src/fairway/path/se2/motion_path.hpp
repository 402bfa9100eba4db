// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/geometry/robot_model.hpp"

namespace fairway {

/// A piece of a path in SE(2) with a constant body twist: an arc, a line, or a turn on the spot.
struct MotionPiece {
  PlanarTwist twist;    ///< per unit of `amount`: a unit of length, or 1 rad where it only turns
  double amount = 0.0;  ///< [m], or [rad] where it only turns; not negative

  [[nodiscard]] Pose2 from(const Pose2& pose) const noexcept { return moved(pose, twist, amount); }
};

/// Geometry without time in SE(2): pieces of constant twist, one after the other.
struct MotionPath {
  Pose2 start;
  std::vector<MotionPiece> pieces;

  [[nodiscard]] Pose2 end() const noexcept;

  /// Length that the reference point travels [m].
  [[nodiscard]] double length() const noexcept;
};

/// Whether two pieces have the same twist per unit, up to rounding: then they can be one.
[[nodiscard]] bool same_direction(const MotionPiece& a, const MotionPiece& b) noexcept;

/// Joins pieces of the same twist, and drops those without extent.
void merge_pieces(MotionPath& path);

/// The same motion from its end to its start.
[[nodiscard]] MotionPath reversed(const MotionPath& path);

/// What a search minimises: about the time that a base needs, from its limits.
///
/// Pieces take the time at their greatest speed. Changes between them take the time to brake, to
/// turn the steered wheel and to accelerate again.
class MotionCost {
 public:
  /// @param reverse_factor  Cost factor of driving backwards; at least 1.
  /// @param cusp_factor     Factor of the time of a cusp as its cost; at least 1.
  MotionCost(const BaseModel& base, double reverse_factor, double cusp_factor = 1.0);

  [[nodiscard]] double of(const MotionPiece& piece) const noexcept;
  [[nodiscard]] double between(const MotionPiece& before, const MotionPiece& after) const noexcept;
  [[nodiscard]] double of(const std::vector<MotionPiece>& pieces) const noexcept;

  [[nodiscard]] const BaseModel& base() const noexcept { return base_; }

  /// Least cost of a metre of travel, and of a radian of turning: bounds for heuristics.
  [[nodiscard]] double per_metre() const noexcept { return per_metre_; }
  [[nodiscard]] double per_radian() const noexcept { return per_radian_; }

 private:
  BaseModel base_;
  double reverse_factor_;
  double cusp_factor_;
  double pause_;  // what it costs to brake to standstill and accelerate again [s]
  double per_metre_;
  double per_radian_;
};

}  // namespace fairway
