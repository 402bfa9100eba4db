// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "fairway/corridor/corridor.hpp"
#include "fairway/corridor/corridor_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway {

/// Covers a path with rectangles, Algorithm 2 or the fewest, as `settings.method` says.
///
/// When the status is Built: every rectangle is free (is_free with clearance 0 in Workspace, with
/// `robot_radius` in Configuration), the first admissible one holds the start and the last the
/// goal, and consecutive admissible ones overlap by at least `settings.min_overlap_area`. Where
/// Fewest finds no room for that patch, the rectangles of Mdsrc are tried before it gives up. A
/// radius that is negative or not finite, or a setting out of its range, gives InvalidInput.
[[nodiscard]] CorridorResult build_corridor(const BitGrid& obstacles,
                                            const Path& path,
                                            double robot_radius,
                                            const CorridorSettings& settings);

/// A block of cells, both corners included.
struct CellBlock {
  CellIndex min;
  CellIndex max;
};

/// Keeps a corridor up to date while the map changes, once per control cycle.
///
/// Keeps what it built: after a change only rectangles that are no longer free, and those beside
/// cells that became free, are made anew. What it answers depends on its whole history of calls,
/// and on nothing else. Not thread-safe.
class CorridorBuilder {
 public:
  CorridorBuilder();
  CorridorBuilder(CorridorBuilder&&) noexcept;
  CorridorBuilder& operator=(CorridorBuilder&&) noexcept;
  ~CorridorBuilder();

  /// As build_corridor; reuses memory.
  const CorridorResult& build(const BitGrid& obstacles,
                              const Path& path,
                              double robot_radius,
                              const CorridorSettings& settings);

  /// Brings the corridor up to date after cells inside `changed` may have changed (clipped to the
  /// map); the rest of the map must be as it was. A chain that is Built keeps all the promises of
  /// build_corridor, is as short as before where nothing changed, and gets shorter where the change
  /// allows it. Builds everything anew when the last result was not Built or came from Mdsrc, when
  /// the map's frame is another, or when the chain cannot be repaired. Does nothing before the
  /// first build.
  const CorridorResult& update(const BitGrid& obstacles, const CellBlock& changed);

  [[nodiscard]] const CorridorResult& result() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fairway
