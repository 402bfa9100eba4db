// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "fairway/corridor/corridor.hpp"
#include "fairway/corridor/corridor_settings.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway {

/// Covers a path with rectangles, by the method that `settings.method` selects.
///
/// If the status is Built, every rectangle is free (is_free with clearance 0 in Workspace, with
/// `robot_radius` in Configuration). The first admissible rectangle contains the start and the last
/// one the goal. Consecutive admissible rectangles overlap by at least `settings.min_overlap_area`.
/// Where Fewest finds no space for that overlap, the rectangles of Mdsrc (Algorithm 2) are tried
/// before it gives up. A radius that is negative or not finite, or a setting out of its range,
/// gives InvalidInput.
[[nodiscard]] CorridorResult build_corridor(const BitGrid& obstacles,
                                            const Path& path,
                                            double robot_radius,
                                            const CorridorSettings& settings);

/// Keeps a corridor up to date while the map changes, once per control cycle.
///
/// After a change it rebuilds only rectangles that are no longer free, and those beside cells that
/// became free. The result depends on the whole history of calls, and on nothing else. Not
/// thread-safe.
class CorridorBuilder {
 public:
  CorridorBuilder();
  CorridorBuilder(CorridorBuilder&&) noexcept;
  CorridorBuilder& operator=(CorridorBuilder&&) noexcept;
  ~CorridorBuilder();

  /// Builds a corridor as build_corridor does; reuses memory.
  const CorridorResult& build(const BitGrid& obstacles,
                              const Path& path,
                              double robot_radius,
                              const CorridorSettings& settings);

  /// Updates the corridor after cells inside `changed` may have changed (clipped to the map).
  ///
  /// The rest of the map must be unchanged. A chain that is Built keeps all guarantees of
  /// build_corridor. It is as short as before where nothing changed, and shorter where the change
  /// allows it. The whole corridor is built again if the last result was not Built or came from
  /// Mdsrc, if the map's frame changed, or if the chain cannot be repaired. Before the first build
  /// the call has no effect.
  const CorridorResult& update(const BitGrid& obstacles, const CellWindow& changed);

  /// Returns the result of the last build or update.
  [[nodiscard]] const CorridorResult& result() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fairway
