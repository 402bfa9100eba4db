// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/perception/lidar_scan.hpp"
#include "fairway/perception/perception_settings.hpp"

namespace fairway {

/// A map of what the lidar has seen around the robot, in a square window that follows it.
///
/// Every cell holds evidence: up where a beam ends, down where one passes, at most once each per
/// scan, and a cell that is hit in a scan is not cleared by it. Above zero it is occupied, else
/// free; a cell that no beam has touched is unknown. The window's axes are those of the world; it
/// moves by whole blocks of kBlock cells, and what enters it is unknown.
///
/// Two readings: `occupied` lets unknown space pass (to plan ways through it), `not_seen_free`
/// blocks it (to drive no faster than can be stopped inside what was seen). No allocation after
/// construction; deterministic.
class RollingGrid {
 public:
  static constexpr int kBlock = 64;  ///< cells by which the window moves: one word of a BitGrid
  static constexpr int kNewScans = 20;

  /// @param settings  As validated; the window is rounded up to whole blocks, an odd number.
  /// @param center  Where the window is at first [m].
  RollingGrid(const PerceptionSettings& settings, const Eigen::Vector2d& center);

  /// Takes over what one scan says. Beams that hit something moving clear up to and including
  /// their end, and mark nothing.
  /// @param robot  Where the robot is: the window follows it.
  /// @param body_radius  Cells nobody has seen count as free where the robot itself stands, and a
  ///        cell's diagonal around it [m].
  void insert(std::span<const Beam> beams,
              const Eigen::Vector2d& robot,
              double body_radius) noexcept;

  [[nodiscard]] const GridFrame& frame() const noexcept { return occupied_.frame(); }
  [[nodiscard]] const BitGrid& occupied() const noexcept { return occupied_; }
  [[nodiscard]] const BitGrid& not_seen_free() const noexcept { return not_seen_free_; }

  /// Whether the last insert moved the window.
  [[nodiscard]] bool rolled() const noexcept { return rolled_; }

  /// Where `occupied` changed in the last insert, apart from rolling; empty if nowhere.
  [[nodiscard]] const CellWindow& changed() const noexcept { return changed_; }

  /// Occupied, Free or Unknown; Unknown outside the window.
  [[nodiscard]] CellState at(CellIndex cell) const noexcept;

  /// Whether something in this cell must have come there lately: beams had passed it so often that
  /// it was surely free, and since then it was hit in no more than kNewScans scans. False outside.
  [[nodiscard]] bool would_be_new(CellIndex cell) const noexcept;

 private:
  struct Cell {
    std::int8_t evidence = 0;
    std::uint8_t scan = 0;     // that touched it last; kNever for unknown cells
    std::uint8_t newness = 0;  // kNewScans when surely free, then less by one with every hit
  };
  static constexpr std::uint8_t kNever = 255;

  void follow(const Eigen::Vector2d& robot) noexcept;
  void roll(int blocks_x, int blocks_y) noexcept;
  void next_scan() noexcept;
  void mark(const Beam& beam) noexcept;
  void clear(const Beam& beam, double known) noexcept;
  void claim_body(const Eigen::Vector2d& robot, double radius) noexcept;
  void add(CellIndex cell, Cell& value, int evidence) noexcept;
  [[nodiscard]] Cell& cell_of(CellIndex cell) noexcept {
    return cells_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(side_) +
                  static_cast<std::size_t>(cell.x)];
  }
  [[nodiscard]] const Cell& cell_of(CellIndex cell) const noexcept {
    return cells_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(side_) +
                  static_cast<std::size_t>(cell.x)];
  }

  PerceptionSettings settings_;
  int side_;  // [cells]
  std::vector<Cell> cells_;
  BitGrid occupied_;
  BitGrid not_seen_free_;
  std::uint8_t scan_ = 0;  // number of this scan, 0..kNever - 1
  bool rolled_ = false;
  CellWindow changed_{.first = {.x = 0, .y = 0}, .last = {.x = -1, .y = -1}};
};

}  // namespace fairway
