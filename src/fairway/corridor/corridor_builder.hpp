// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "fairway/base/setting.hpp"
#include "fairway/corridor/corridor.hpp"
#include "fairway/map/bit_grid.hpp"
#include "fairway/path/path.hpp"

namespace fairway {

/// Method by which a corridor is built.
enum class CorridorMethod : std::uint8_t {
  Mdsrc,   ///< Algorithms 1 and 2 of the paper, corrected; with one orientation this is SRC [13]
  Fewest,  ///< the fewest rectangles, each as large as possible; the default
};

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(CorridorMethod /*type*/) noexcept {
  return {"mdsrc", "fewest"};
}

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(CorridorSpace /*type*/) noexcept {
  return {"workspace", "configuration"};
}

/// Settings of the corridor.
struct CorridorSettings {
  CorridorMethod method = CorridorMethod::Fewest;
  CorridorSpace space = CorridorSpace::Configuration;
  int num_orientations = 10;   ///< N_c: number of orientations that Mdsrc tries, Eq. (4)
  double growth_step = 0.1;    ///< Delta_L: step by which a side advances in Mdsrc [m]
  double max_growth = 8.0;     ///< L_max: greatest distance of a side from the seed, in Mdsrc [m]
  double longest_side = 16.0;  ///< longest side of a rectangle of Fewest [m]
  /// Delta_s: distance of the robot's centre from the sides, Workspace only [m].
  double inward_offset = 0.3;
  double min_overlap_area = 0.01;  ///< least overlap of consecutive admissible rectangles [m^2]
  double waypoint_spacing = 0.1;   ///< spacing of the path points that Mdsrc grows from [m]
};

template <typename Settings, typename Visitor>
void visit_corridor(Settings& s, Visitor&& field) {
  field(s.method, SettingInfo{"method", "",
                              "how rectangles are built: mdsrc (Algorithms 1 and 2 of the paper) "
                              "or fewest (as few and as large as possible)"});
  field(s.space, SettingInfo{"space", "",
                             "where rectangles are free: workspace (of obstacles, as in the paper) "
                             "or configuration (for the centre of the robot's disc)"});
  field(s.num_orientations,
        SettingInfo{
            "num_orientations", "",
            "number of orientations that mdsrc tries; more give larger rectangles and take longer",
            1, 360});
  field(
      s.growth_step,
      SettingInfo{"growth_step", "m",
                  "step by which a side advances in mdsrc; a smaller step takes longer", 1e-3, 10});
  field(s.max_growth,
        SettingInfo{"max_growth", "m", "greatest distance of a side from the seed in mdsrc", 0.05,
                    1000});
  field(s.longest_side, SettingInfo{"longest_side", "m",
                                    "longest side of a rectangle of fewest; a greater value gives "
                                    "fewer and larger rectangles",
                                    0.1, 1000});
  field(s.inward_offset,
        SettingInfo{"inward_offset", "m",
                    "least distance between the robot's centre and the sides, in workspace only", 0,
                    10});
  field(s.min_overlap_area, SettingInfo{"min_overlap_area", "m^2",
                                        "least overlap of consecutive rectangles; a greater value "
                                        "eases the change from one to the next",
                                        0, 100});
  field(s.waypoint_spacing,
        SettingInfo{"waypoint_spacing", "m",
                    "spacing of the path points that mdsrc grows rectangles from", 0.01, 10});
}

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
