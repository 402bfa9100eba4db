// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/perception/lidar_scan.hpp"
#include "fairway/perception/perception_settings.hpp"

namespace fairway {

/// A map of what the lidar has measured around the robot, in a square window that follows it.
///
/// Every cell holds evidence. It increases where a beam ends and decreases where a beam crosses,
/// each at most once per scan; a cell that is hit in a scan is not cleared by it. A cell is
/// occupied if its evidence is above zero, and otherwise free. A cell that no beam has touched is
/// unknown. The window is aligned with the world's axes and moves by whole blocks of kBlock cells;
/// cells that enter it are unknown.
///
/// There are two readings. In `occupied` unknown cells are free, for planning paths through them.
/// In `not_seen_free` they are blocked, so that the robot can always stop inside what was measured.
///
/// Occupied cells can be doubted: `occupied` then treats them as unknown until the next beam
/// reaches them. Their evidence remains, and `not_seen_free` does not change. Does not allocate
/// after construction; deterministic.
class RollingGrid {
 public:
  /// Step by which the window moves [cells]: one word of a BitGrid.
  static constexpr int kBlock = 64;
  static constexpr int kNewScans = 20;
  static constexpr int kProofScans = 20;

  /// @param settings  Valid settings; the window is rounded up to an odd number of blocks.
  /// @param center  Initial centre of the window [m].
  RollingGrid(const PerceptionSettings& settings, const Eigen::Vector2d& center);

  /// Processes one scan. Beams that hit a moving object clear all their cells and mark none; if the
  /// cell where they end is unknown, it remains unknown.
  /// @param robot  Position of the robot; the window follows it.
  /// @param body_radius  Radius of the robot's disc [m]. Unknown cells within this radius plus a
  ///       cell's diagonal become free.
  void insert(std::span<const Beam> beams,
              const Eigen::Vector2d& robot,
              double body_radius) noexcept;

  /// Unknown cells within `radius` plus a cell's diagonal of `center` become free: a part of the
  /// robot is there.
  void claim(const Eigen::Vector2d& center, double radius) noexcept { claim_body(center, radius); }

  /// Sets the zones that both readings carry; null for none.
  void set_zones(std::shared_ptr<const ZoneMap> zones) noexcept {
    occupied_.set_zones(zones);
    not_seen_free_.set_zones(std::move(zones));
  }

  [[nodiscard]] const GridFrame& frame() const noexcept { return occupied_.frame(); }
  [[nodiscard]] const BitGrid& occupied() const noexcept { return occupied_; }
  [[nodiscard]] const BitGrid& not_seen_free() const noexcept { return not_seen_free_; }

  /// Whether the last insert moved the window.
  [[nodiscard]] bool rolled() const noexcept { return rolled_; }

  /// Cells where `occupied` changed in the last insert, apart from moving the window; may be empty.
  [[nodiscard]] const CellWindow& changed() const noexcept { return changed_; }

  /// Returns Occupied, Free or Unknown; Unknown outside the window.
  [[nodiscard]] CellState at(CellIndex cell) const noexcept;

  /// Returns whether an obstacle in this cell must have come there recently. Beams had crossed the
  /// cell until it was surely free, and since then at most kNewScans scans hit it. False outside
  /// the window.
  [[nodiscard]] bool would_be_new(CellIndex cell) const noexcept;

  /// Returns whether a static obstacle is known within `reach` cells along both axes: it is
  /// occupied, and either was never surely free, or has been hit in kNewScans scans since.
  [[nodiscard]] bool is_static_near(CellIndex cell, int reach = 1) const noexcept;

  /// Returns whether this cell or a neighbour is static by evidence: as is_static_near, and hit in
  /// kProofScans scans. An object that was there when it came into view may still move away.
  [[nodiscard]] bool is_proven_static(CellIndex cell) const noexcept;

  /// Doubts every occupied cell that none of the last `scans` scans has touched.
  /// @return the cells where `occupied` changed; may be empty.
  CellWindow doubt_unseen(int scans) noexcept;

 private:
  struct Cell {
    std::int8_t evidence = 0;
    // kNewScans once surely free; each hit subtracts one. The first hit of a cell that never was
    // sets kUnproven + kProofScans, and each further one subtracts one down to kUnproven.
    std::uint8_t newness = 0;
    // The last scan that touched it; kNever if unknown. Of surely free cells, the last that
    // changed it.
    std::uint16_t scan = 0;
  };
  static constexpr std::uint16_t kNever = 0xFFFF;
  static constexpr std::uint8_t kUnproven = 0x80;
  static_assert(kNewScans < kUnproven && kProofScans < kUnproven);

  void follow(const Eigen::Vector2d& robot) noexcept;
  void roll(int blocks_x, int blocks_y) noexcept;
  void next_scan() noexcept;
  void mark(const Beam& beam) noexcept;
  void clear(const Beam& beam, double known) noexcept;
  void claim_body(const Eigen::Vector2d& robot, double radius) noexcept;
  void add(CellIndex cell, Cell& value, int evidence) noexcept;
  [[nodiscard]] bool is_surely_free(CellIndex cell) const noexcept {
    return (surely_free_[word_of(cell)] >> (cell.x % kBlock) & 1U) != 0;
  }
  [[nodiscard]] std::size_t word_of(CellIndex cell) const noexcept {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(side_ / kBlock) +
           static_cast<std::size_t>(cell.x / kBlock);
  }
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
  // One bit per cell: known, with the least evidence. Most cells that beams cross are, and their
  // bits fit into the fastest memory.
  std::vector<std::uint64_t> surely_free_;
  BitGrid occupied_;
  BitGrid not_seen_free_;
  std::uint16_t scan_ = 0;  // number of the present scan, 0..kNever - 1
  bool rolled_ = false;
  CellWindow changed_{.first = {.x = 0, .y = 0}, .last = {.x = -1, .y = -1}};
};

}  // namespace fairway
