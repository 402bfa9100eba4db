// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
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

/// Cost of a node that no search has reached.
inline constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();

/// A lattice of nodes in the form that GridSearch reads. It has one byte per node and a border of
/// blocked nodes.
///
/// A byte of 0 means that there is no node. Otherwise its lower bits are the cost per step in units
/// of `unit`. kOpen means that the node and its eight neighbours are all linked, and that costs
/// differ so little here that GridSearch may skip detours.
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

  /// The unit of all grids for these costs: the finest one for which every cost fits into a byte.
  [[nodiscard]] static int unit_for(const TravelCost& costs) noexcept;

 protected:
  // Sets the distance between nodes to `spacing` [cells]. New bytes are not initialised.
  void resize(const TravelCost& costs, int spacing);
  [[nodiscard]] std::size_t size() const noexcept {
    return static_cast<std::size_t>(stride()) * (static_cast<std::size_t>(height_) + 2);
  }

  // Returns the byte of a node with a cost per metre; never 0.
  [[nodiscard]] std::uint8_t byte_of(float cost) const noexcept {
    return to_byte(cost, static_cast<float>(unit_));
  }
  [[nodiscard]] static std::uint8_t to_byte(float cost, float unit) noexcept {
    const int units = static_cast<int>(cost * unit + 0.5F);
    return static_cast<std::uint8_t>(std::min(units, static_cast<int>(kCost)));
  }

  // Returns whether GridSearch may skip detours at a node (see GridSearch::run). The node and its
  // neighbours must all exist, and their costs must differ little.
  [[nodiscard]] bool is_gentle(int index) const noexcept;
  [[nodiscard]] static constexpr bool is_gentle(int least_cost, int greatest_cost) noexcept {
    return 58 * greatest_cost < 106 * least_cost;
  }

  const TravelCost* costs_ = nullptr;
  std::vector<std::uint8_t> nodes_;

 private:
  int width_ = 0;
  int height_ = 0;
  int unit_ = 1;
};

/// The map at a quarter of its resolution. A node is a block of 4 x 4 cells with at least one
/// allowed cell.
///
/// The cost of a node is that of its cell with the greatest clearance. Two blocks are linked if
/// allowed cells of both are neighbours. Everything that is connected on the map is therefore
/// connected here; the reverse fails only where a block has allowed cells on both sides of a thin
/// obstacle. Rows are computed on first use, so a short path on a large map costs little, and kept
/// for further searches on the same map.
class BlockGrid : public SearchGrid {
 public:
  static constexpr int kSide = 4;  ///< side of a block [cells]

  /// Sets the map; `costs` must outlive the searches on it.
  /// @return Whether all nodes are the same as before. Maps with zones never count as the same.
  bool begin(const TravelCost& costs);

  /// Starts a search: no row is prepared.
  void restart() noexcept { first_row_ = 0, last_row_ = -1; }

  [[nodiscard]] static CellIndex block_of(CellIndex cell) noexcept {
    return {.x = cell.x / kSide, .y = cell.y / kSide};
  }

  /// Prepares rows `first` to `last`, and all rows between them and those already prepared. Sets
  /// their part of `so_far` to kUnreached.
  void prepare_rows(int first, int last, std::uint32_t* so_far) {
    if (first < first_row_ || last > last_row_) extend_rows(first, last, so_far);
  }

  /// Returns whether `node` is linked to its neighbour in `direction`. @pre both are nodes.
  [[nodiscard]] bool linked(CellIndex node, unsigned direction) const noexcept;

 private:
  void extend_rows(int first, int last, std::uint32_t* so_far);
  void compute_rows(int first, int last);
  void fill_row(int y);  // computes costs and masks
  void open_row(int y);  // sets kOpen where all neighbouring blocks are full
  [[nodiscard]] std::uint16_t allowed_cells(CellIndex node) const noexcept;

  // What the rows were computed from.
  BitGrid map_;
  double reach_ = 0.0;
  TravelCost::Scale scale_;

  int first_row_ = 0;  // prepared for this search
  int last_row_ = -1;
  int first_computed_ = 0;
  int last_computed_ = -1;
  // By index: bit 4 y + x is set if that cell of the block is allowed.
  std::vector<std::uint16_t> masks_;
  // Greatest and least distance in the four cells of every column of a row of blocks, and in every
  // block of that row [m].
  std::vector<float> greatest_;
  std::vector<float> tightest_;
  std::vector<float> block_greatest_;
  std::vector<float> block_tightest_;
  std::vector<float> outside_;  // a row of cells outside the map
  // Cells that are allowed in three rows, and their least and greatest cost.
  std::vector<std::uint16_t> column_masks_;
  std::vector<std::uint8_t> column_least_;
  std::vector<std::uint8_t> column_most_;
};

/// The cells of the map, or of some blocks of it: a node is an allowed cell.
class CellGrid : public SearchGrid {
 public:
  /// Starts a search over all cells of the map, or over those of `blocks` and kReach cells around
  /// each. `costs` must outlive it.
  void begin(const TravelCost& costs);
  void begin(const TravelCost& costs, std::span<const CellIndex> blocks);

  /// Starts a search: no node is prepared.
  void restart() noexcept { prepared_ = false; }

  /// Sets `so_far` to kUnreached at every node, at the first call after `restart`.
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
  std::vector<int> indices_;  // indices of the nodes; all other bytes are 0
};

}  // namespace fairway
