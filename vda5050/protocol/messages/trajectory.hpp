// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "protocol/messages/field_reader.hpp"

namespace fairway::vda5050 {

/// A control point of a NURBS curve.
struct ControlPoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  double weight = 1.0;
};

/// A clamped NURBS curve, the trajectory of an edge.
struct Trajectory {
  int degree = 1;
  std::vector<double> knots;  ///< number of points + degree + 1
  std::vector<ControlPoint> points;

  /// Returns the point at `parameter` by de Boor's algorithm in homogeneous coordinates; the
  /// parameter is clamped to the range of the knots. @pre the trajectory is sound.
  [[nodiscard]] Eigen::Vector2d at(double parameter) const;

  /// Returns a polyline from the first to the last point whose chords are at most `chord` [m] long
  /// and deviate at most `sagitta` [m] from the curve. @pre the trajectory is sound.
  [[nodiscard]] std::vector<Eigen::Vector2d> polyline(double chord, double sagitta) const;
};

/// Reads a trajectory and checks its knots: their number, clamped ends, order and multiplicity.
/// @param needs_knots  Whether degree and knots must be given, as in version 2; version 3 has the
///     degree 1 and uniform knots as defaults.
[[nodiscard]] Trajectory read_trajectory(FieldReader& reader, bool needs_knots);

[[nodiscard]] nlohmann::json to_json(const Trajectory& trajectory);

/// Returns the degree 1 curve through points, with knots by arc length.
[[nodiscard]] Trajectory polyline_trajectory(const std::vector<Eigen::Vector2d>& points);

}  // namespace fairway::vda5050
