// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "fairway/path/travel_cost.hpp"

namespace fairway {

/// Steps to the eight neighbours, counter-clockwise from +x; odd directions are diagonal.
inline constexpr std::array<int, 8> kStepX{1, 1, 0, -1, -1, -1, 0, 1};
inline constexpr std::array<int, 8> kStepY{0, 1, 1, 1, 0, -1, -1, -1};

/// Cost so far of a node that no search has reached.
inline constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();

/// Nodes on a lattice, as GridSearch wants them: a byte per node, with one blocked node around all.
///
/// The byte is 0 where no node is. Otherwise its lower bits are the cost per step in units of
/// `unit`, and kOpen says that the node and its eight neighbours are linked without exception and
/// that costs rise so gently here that GridSearch may leave out detours.
class SearchGrid {
 public:
  static constexpr std::uint8_t kOpen = 0x80;
  static constexpr std::uint8_t kCost = 0x7F;

  [[nodiscard]] int width() const noexcept { return width_; }
  [[nodiscard]] int height() const noexcept { return height_; }
  [[nodiscard]] int stride() const noexcept { return width_ + 2; }
  [[nodiscard]] int index(CellIndex node) const noexcept {
    return (node.y + 1) * stride() + node.x + 1;
  }
  [[nodiscard]] const std::uint8_t* nodes() const noexcept { return nodes_.data(); }
  [[nodiscard]] int unit() const noexcept { return unit_; }  ///< the least cost of a node

  /// The unit of all grids for these costs: the finest that a byte has room for.
  [[nodiscard]] static int unit_for(const TravelCost& costs) noexcept;

 protected:
  // `spacing` between nodes [cells]. The bytes are unset when they did not fit before.
  void resize(const TravelCost& costs, int spacing);
  [[nodiscard]] std::size_t size() const noexcept {
    return static_cast<std::size_t>(stride()) * (static_cast<std::size_t>(height_) + 2);
  }

  // Cost at a distance, as a node's byte; not 0.
  [[nodiscard]] std::uint8_t byte_at(float distance) const noexcept {
    return static_cast<std::uint8_t>(
        static_cast<int>(costs_->at_distance(distance) * static_cast<float>(unit_) + 0.5F));
  }

  // Whether a node and its neighbours all are nodes, and their costs differ so little that
  // GridSearch may leave out detours (see GridSearch::run).
  [[nodiscard]] bool is_gentle(int index) const noexcept;

  const TravelCost* costs_ = nullptr;
  std::vector<std::uint8_t> nodes_;

 private:
  int width_ = 0;
  int height_ = 0;
  int unit_ = 1;
};

/// The map at a quarter of its resolution: a node is a block of 4 x 4 cells of which one at least
/// is allowed, with the cost of its roomiest cell. Blocks are linked where allowed cells of both
/// are neighbours. So what is connected on the map is connected here; the reverse fails only where
/// a block has allowed cells on both sides of something thin. Rows are computed when they are first
/// asked for: a short path on a large map is cheap.
class BlockGrid : public SearchGrid {
 public:
  static constexpr int kSide = 4;  ///< of a block [cells]

  /// Keeps `costs` for later calls.
  void begin(const TravelCost& costs);

  [[nodiscard]] static CellIndex block_of(CellIndex cell) noexcept {
    return {.x = cell.x / kSide, .y = cell.y / kSide};
  }

  /// Makes rows `first` to `last` known, and all between them and those already known; sets their
  /// part of `so_far` to kUnreached.
  void prepare_rows(int first, int last, std::uint32_t* so_far) {
    if (first < first_row_ || last > last_row_) extend_rows(first, last, so_far);
  }

  /// Whether there is a link to the neighbour in `direction`. @pre both are nodes.
  [[nodiscard]] bool linked(CellIndex node, unsigned direction) const noexcept;

 private:
  void extend_rows(int first, int last, std::uint32_t* so_far);
  void fill_row(int y);  // costs and masks
  void open_row(int y);  // adds kOpen where all around is full
  [[nodiscard]] std::uint16_t allowed_cells(CellIndex node) const noexcept;

  int first_row_ = 0;
  int last_row_ = -1;
  std::vector<std::uint16_t> masks_;  // bit 4 y + x of a block: is that cell allowed; by index
  std::vector<float> roomiest_;       // of the four cells of every column of a row of blocks [m]
  std::vector<float> tightest_;
};

/// The cells of the map, or of some blocks of it: a node is an allowed cell.
class CellGrid : public SearchGrid {
 public:
  /// Keeps `costs` for later calls. With all cells of the map, or with those of `blocks` and
  /// kReach cells around each.
  void begin(const TravelCost& costs);
  void begin(const TravelCost& costs, std::span<const CellIndex> blocks);

  /// Sets `so_far` to kUnreached at every node, at the first call after `begin`.
  void prepare_rows(int /*first*/, int /*last*/, std::uint32_t* so_far) {
    if (!prepared_) reset(so_far);
  }

  [[nodiscard]] bool linked(CellIndex node, unsigned direction) const noexcept;

 private:
  static constexpr int kReach = 3;

  void clear(const TravelCost& costs);
  void add_cells(CellIndex first, CellIndex last);
  void mark_open();
  void reset(std::uint32_t* so_far);

  bool prepared_ = false;
  std::vector<int> indices_;  // of the nodes; all other bytes are 0
};

}  // namespace fairway
