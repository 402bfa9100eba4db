// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "fairway/map/bit_grid.hpp"

namespace fairway {

/// A point on the surface of an obstacle.
struct SurfacePoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();    ///< unit vector that points to free space
};

/// Points on surfaces in a square window that follows the robot.
///
/// The window consists of cells of kCell metres, each with at most kPerCell points. A point is
/// added only where none is closer than kSpacing, so that surfaces seen many times keep their first
/// points. Cells that leave the window are reused. Does not allocate after construction;
/// deterministic.
class SurfacePoints {
 public:
  static constexpr double kCell = 0.2;       ///< side of a cell [m]
  static constexpr double kSpacing = 0.035;  ///< least distance of the points of a cell [m]
  static constexpr std::size_t kPerCell = 6;

  /// @param window  Side of the window [m].
  explicit SurfacePoints(double window);

  void add(const SurfacePoint& point) noexcept;

  /// Returns the point nearest to `to` within `reach` [m]; null if there is none. Its normal must
  /// be within 60 degrees of that of `to`. @pre reach <= kCell
  [[nodiscard]] const SurfacePoint* nearest(const SurfacePoint& to, double reach) const noexcept;

  /// Whether normals are exact, as those of a known map are. Otherwise they are those of scans.
  [[nodiscard]] bool exact_normals() const noexcept { return exact_normals_; }
  void set_exact_normals(bool exact) noexcept { exact_normals_ = exact; }

  /// Number of points added so far, including those that have left the window.
  [[nodiscard]] std::size_t added() const noexcept { return added_; }

 private:
  struct Cell {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::uint32_t count = 0;
    std::array<SurfacePoint, kPerCell> points;
  };

  [[nodiscard]] std::size_t index(std::int32_t x, std::int32_t y) const noexcept {
    return (static_cast<std::size_t>(static_cast<std::uint32_t>(y)) & mask_) * (mask_ + 1) +
           (static_cast<std::size_t>(static_cast<std::uint32_t>(x)) & mask_);
  }

  std::size_t mask_;  // number of cells along a side, a power of two, less one
  std::vector<Cell> cells_;
  std::size_t added_ = 0;
  bool exact_normals_ = false;
};

/// Computes the points of a scan and their normals from the neighbours of each point.
///
/// A point without at least two neighbours within kNear on a line has no normal and is left out.
/// @param ends    Ends of the beams in the order of their angle; beams without a hit are NaN.
/// @param sensor  Position of the sensor: normals point towards it.
/// @param points  Filled with the points; keeps its memory.
/// @param beams   Filled with the number of the beam of each point.
void surface_of_scan(std::span<const Eigen::Vector2d> ends,
                     const Eigen::Vector2d& sensor,
                     std::vector<SurfacePoint>& points,
                     std::vector<std::size_t>& beams);

/// Adds the surfaces of the blocked cells of a map. Each side of a cell that faces a free cell adds
/// one point, with a normal from the neighbouring sides.
void add_surface_of_map(const BitGrid& map, SurfacePoints& points);

}  // namespace fairway
