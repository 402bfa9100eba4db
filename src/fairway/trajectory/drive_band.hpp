// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

namespace fairway {

/// A line with a greatest distance from it. Places on the line are searched near the one before
/// only, so the line may come near itself.
struct DriveBand {
  std::vector<Eigen::Vector2d> points;  ///< at least one
  std::vector<double> arcs;             ///< arc length at each point [m]
  double half_width = 0.0;              ///< [m]

  struct Nearest {
    Eigen::Vector2d point = Eigen::Vector2d::Zero();
    double arc = 0.0;
    double distance = 0.0;  ///< [m]
  };

  /// The nearest point at an arc length between two; the first one where several are.
  [[nodiscard]] Nearest nearest(const Eigen::Vector2d& position,
                                double from,
                                double to) const noexcept;

  /// The nearest point to the next place of something that was at `arc` and has moved by `moved`.
  [[nodiscard]] Nearest next(const Eigen::Vector2d& position,
                             double arc,
                             double moved) const noexcept;
};

}  // namespace fairway
