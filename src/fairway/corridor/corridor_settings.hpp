// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "fairway/base/setting.hpp"
#include "fairway/corridor/corridor.hpp"

namespace fairway {

/// Which corridor is built.
enum class CorridorMethod : std::uint8_t {
  Mdsrc,   ///< the paper's Algorithms 1 and 2, made sound; with one orientation it is SRC [13]
  Fewest,  ///< the fewest largest rectangles, our default
};

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(CorridorMethod /*type*/) noexcept {
  return {"mdsrc", "fewest"};
}

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(CorridorSpace /*type*/) noexcept {
  return {"workspace", "configuration"};
}

struct CorridorSettings {
  CorridorMethod method = CorridorMethod::Fewest;
  CorridorSpace space = CorridorSpace::Configuration;
  int num_orientations = 10;       ///< N_c: turns tried by Mdsrc, Eq. (4)
  double growth_step = 0.1;        ///< Delta_L: how far a side of Mdsrc advances at once [m]
  double max_growth = 8.0;         ///< L_max: furthest side from the seed [m]
  double longest_side = 16.0;      ///< longest side of a rectangle of Fewest [m]
  double inward_offset = 0.3;      ///< Delta_s: used in workspace only [m]
  double min_overlap_area = 0.01;  ///< patch that consecutive admissible rectangles share [m^2]
  double waypoint_spacing = 0.1;   ///< distance of the path points that Mdsrc seeds at [m]
};

template <typename Settings, typename Visitor>
void visit_corridor(Settings& s, Visitor&& field) {
  field(s.method, SettingInfo{"method", "", "mdsrc (the paper's) or fewest (ours)"});
  field(s.space, SettingInfo{"space", "", "workspace (the paper's) or configuration (ours)"});
  field(s.num_orientations, SettingInfo{"num_orientations", "", "turns tried by mdsrc", 1, 360});
  field(s.growth_step,
        SettingInfo{"growth_step", "m", "how far a side of mdsrc advances at once", 1e-3, 10});
  field(s.max_growth, SettingInfo{"max_growth", "m", "furthest side from the seed", 0.05, 1000});
  field(s.longest_side,
        SettingInfo{"longest_side", "m", "longest side of a rectangle of fewest", 0.1, 1000});
  field(s.inward_offset,
        SettingInfo{"inward_offset", "m", "side to robot centre, in workspace only", 0, 10});
  field(s.min_overlap_area,
        SettingInfo{"min_overlap_area", "m^2", "patch that consecutive rectangles share", 0, 100});
  field(s.waypoint_spacing,
        SettingInfo{"waypoint_spacing", "m", "distance of the path points that mdsrc seeds at",
                    0.01, 10});
}

}  // namespace fairway
