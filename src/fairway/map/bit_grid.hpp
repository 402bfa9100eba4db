// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "fairway/base/setting.hpp"
#include "fairway/map/occupancy_grid.hpp"

namespace fairway {

class ZoneMap;

/// Selects how unknown cells are treated.
enum class UnknownCells : std::uint8_t { Occupied, Free };

/// The obstacles of a grid, one bit per cell, 64 cells per word. All geometric tests read this
/// form.
///
/// Next to its rows the grid stores bands: groups of kBandRows rows combined by OR. A test skips a
/// band without obstacles in one step.
///
/// A grid may carry zones beside its cells. The tests of free space obey them exactly: no cell
/// represents a zone.
class BitGrid {
 public:
  static constexpr int kBandRows = 8;  ///< rows in a band; the topmost band may have fewer

  BitGrid() = default;  ///< makes a grid without cells: every cell is blocked

  /// Packs a grid. Occupied cells are blocked, free cells are not, and `unknown` decides for
  /// unknown cells.
  explicit BitGrid(const OccupancyGrid& grid, UnknownCells unknown = UnknownCells::Occupied);

  /// Makes a grid in which no cell is blocked, or every cell is.
  /// @throws std::invalid_argument unless width and height are 0 to OccupancyGrid::kMaxSide, the
  ///         resolution is finite and positive, and the origin is finite.
  BitGrid(const GridFrame& frame, bool blocked);

  [[nodiscard]] const GridFrame& frame() const noexcept { return frame_; }

  /// Whether both have the same frame, cells and zones; zones are compared by identity.
  [[nodiscard]] bool operator==(const BitGrid& other) const noexcept {
    return same_frame(frame_, other.frame_) && zones_ == other.zones_ && words_ == other.words_;
  }

  /// Returns whether a cell is blocked; cells outside the grid are.
  [[nodiscard]] bool blocked(CellIndex cell) const noexcept {
    if (!frame_.contains(cell)) return true;
    return (row(cell.y)[static_cast<std::size_t>(cell.x) / 64] >> (cell.x % 64) & 1U) != 0;
  }

  /// Sets the zones that hold on this map; null for none.
  void set_zones(std::shared_ptr<const ZoneMap> zones) noexcept { zones_ = std::move(zones); }
  [[nodiscard]] const ZoneMap* zones() const noexcept { return zones_.get(); }

  /// Packs another grid, and reuses the memory if the size is unchanged. Keeps the zones.
  void assign(const OccupancyGrid& grid, UnknownCells unknown = UnknownCells::Occupied);

  /// Changes one cell. @pre the cell lies in the grid.
  void set(CellIndex cell, bool blocked) noexcept;

  /// Copies the cells of a window from another grid. @pre both have the same size, and the window
  /// lies in them.
  void copy(const BitGrid& from, const CellWindow& window) noexcept;

  /// Returns the cells of a window as a grid of their own, at the same place in the world and
  /// without the zones. The window is clipped to this grid; an empty one gives a grid without
  /// cells.
  [[nodiscard]] BitGrid part(const CellWindow& window) const;

  /// Moves the cells to another place: `origin` is the new world pose of the lower-left corner.
  void move_to(const Pose2& origin) noexcept { frame_.origin = origin; }

  /// Returns the column of the first blocked cell of row `y` in columns `first` to `last`,
  /// inclusive. The result is -1 if there is none, and for an empty range. @pre 0 <= first, last <
  /// width, 0 <= y < height.
  [[nodiscard]] int first_blocked(int y, int first, int last) const noexcept {
    if (first > last) return -1;
    const std::uint64_t* const words = row(y).data();
    std::size_t w = word_of(first);
    const std::size_t last_word = word_of(last);
    std::uint64_t word = words[w] & from(first);
    while (word == 0 && w < last_word)
      word = words[++w];
    if (w == last_word) word &= up_to(last);
    return word != 0 ? static_cast<int>(w) * 64 + std::countr_zero(word) : -1;
  }

  /// Returns the column of the last blocked cell, otherwise as first_blocked.
  [[nodiscard]] int last_blocked(int y, int first, int last) const noexcept {
    if (first > last) return -1;
    const std::uint64_t* const words = row(y).data();
    std::size_t w = word_of(last);
    const std::size_t first_word = word_of(first);
    std::uint64_t word = words[w] & up_to(last);
    while (word == 0 && w > first_word)
      word = words[--w];
    if (w == first_word) word &= from(first);
    return word != 0 ? static_cast<int>(w) * 64 + 63 - std::countl_zero(word) : -1;
  }

  /// Returns the column of the blocked cell nearest to column `to` in row `y`, columns `first` to
  /// `last`. Of two equally near it returns the right one, and -1 if there is none. @pre as
  /// first_blocked.
  [[nodiscard]] int nearest_blocked(int y, int first, int last, int to) const noexcept {
    const int right = first_blocked(y, to > first ? to : first, last);
    const int left = last_blocked(y, first, to - 1 < last ? to - 1 : last);
    if (right < 0 || left < 0) return right < 0 ? left : right;
    return to - left < right - to ? left : right;
  }

  /// Returns whether any cell of row `y` in columns `first` to `last` is blocked. @pre as
  /// first_blocked.
  [[nodiscard]] bool any_blocked(int y, int first, int last) const noexcept {
    return any_set(row(y).data(), first, last);
  }

  /// Returns whether any cell of band `b` in columns `first` to `last` is blocked. Band b covers
  /// rows kBandRows b to kBandRows (b + 1) - 1. @pre as first_blocked, and the band has a row of
  /// the grid.
  [[nodiscard]] bool any_blocked_in_band(int b, int first, int last) const noexcept {
    return any_set(band(b).data(), first, last);
  }

  /// Returns the words of a row; bit i of word w is column 64 w + i. Bits past the width are 0.
  [[nodiscard]] std::span<const std::uint64_t> row(int y) const noexcept {
    return {words_.data() + static_cast<std::size_t>(y) * words_per_row_, words_per_row_};
  }

  /// Returns the words of a band; a bit is set if any row of the band is blocked there.
  [[nodiscard]] std::span<const std::uint64_t> band(int b) const noexcept {
    return {bands_.data() + static_cast<std::size_t>(b) * words_per_row_, words_per_row_};
  }

  /// Rewrites whole rows: calls write(row) once, where row(y) returns the writable words of row y.
  /// Bits past the width must stay 0.
  template <typename Write>
  void rewrite(Write&& write) {
    write([this](int y) {
      return std::span<std::uint64_t>(words_.data() + static_cast<std::size_t>(y) * words_per_row_,
                                      words_per_row_);
    });
    make_bands();
  }

 private:
  // The word that holds a column, and masks of its bits from that column on and up to that column.
  [[nodiscard]] static std::size_t word_of(int column) noexcept {
    return static_cast<std::size_t>(column) / 64;
  }
  [[nodiscard]] static std::uint64_t from(int column) noexcept {
    return ~0ULL << (static_cast<unsigned>(column) % 64);
  }
  [[nodiscard]] static std::uint64_t up_to(int column) noexcept {
    return ~0ULL >> (63 - static_cast<unsigned>(column) % 64);
  }

  [[nodiscard]] static bool any_set(const std::uint64_t* words, int first, int last) noexcept {
    if (first > last) return false;
    std::size_t w = word_of(first);
    const std::size_t last_word = word_of(last);
    std::uint64_t found = words[w] & from(first);
    while (w < last_word && found == 0)
      found = words[++w];
    if (w == last_word) found &= up_to(last);
    return found != 0;
  }

  void make_bands();

  GridFrame frame_;
  std::size_t words_per_row_ = 0;
  std::vector<std::uint64_t> words_;
  std::vector<std::uint64_t> bands_;
  std::shared_ptr<const ZoneMap> zones_;
};

/// Settings for reading a map.
struct MapSettings {
  bool unknown_is_occupied = true;  ///< whether unknown cells count as obstacles
};

/// Returns how `settings` treat unknown cells.
[[nodiscard]] inline UnknownCells unknown_cells(const MapSettings& settings) noexcept {
  return settings.unknown_is_occupied ? UnknownCells::Occupied : UnknownCells::Free;
}

template <typename Settings, typename Visitor>
void visit_map(Settings& s, Visitor&& field) {
  field(s.unknown_is_occupied,
        SettingInfo{"unknown_is_occupied", "", "whether unknown cells count as obstacles"});
}

}  // namespace fairway
