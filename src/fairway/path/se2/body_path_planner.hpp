// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/base/setting.hpp"
#include "fairway/map/body_clearance.hpp"
#include "fairway/path/se2/motion_path.hpp"

namespace fairway {

/// How a path for a body is searched.
struct BodyPathSettings {
  double margin = 0.05;         ///< clearance tried first; smaller ones follow [m]
  double cell = 0.05;           ///< side of a cell of states [m]; halved when nothing is found
  int headings = 72;            ///< cells of heading in a full turn
  double greediness = 1.5;      ///< weight of the estimate of what is left; 1: the cheapest path
  double reverse_factor = 1.0;  ///< cost factor of driving backwards
  double cusp_factor = 1.0;     ///< factor of a cusp's time as its cost
  int max_states = 200000;      ///< states expanded before the search gives up, per margin
  int total_states = 2000000;   ///< the same for all margins and cells together
  int shortcut_tries = 150;     ///< parts of the path for which a shortcut is tried
};

template <typename Settings, typename Visitor>
void visit_body_path(Settings& s, Visitor&& field) {
  field(s.margin, SettingInfo{"margin", "m", "clearance tried first; smaller ones follow", 0, 10});
  field(s.cell, SettingInfo{"cell", "m", "side of a cell of states", 0.005, 1});
  field(s.headings, SettingInfo{"headings", "", "cells of heading in a full turn", 8, 360});
  field(s.greediness,
        SettingInfo{"greediness", "", "weight of the estimate of what is left", 1, 10});
  field(s.reverse_factor,
        SettingInfo{"reverse_factor", "", "cost factor of driving backwards", 1, 100});
  field(s.cusp_factor,
        SettingInfo{"cusp_factor", "", "factor of a cusp's time as its cost, for steered bases", 1,
                    100});
  field(s.max_states,
        SettingInfo{"max_states", "", "states expanded before the search gives up", 1, 1e8});
  field(s.total_states,
        SettingInfo{"total_states", "", "states expanded by all searches for a path", 1, 1e8});
  field(s.shortcut_tries, SettingInfo{"shortcut_tries", "",
                                      "parts of the path for which a shortcut is tried", 0, 1e6});
}

/// How a search for a body ended.
enum class BodyPathStatus : std::uint8_t {
  Found,         ///< there is a path
  StartBlocked,  ///< the body at the start touches an obstacle, or leaves the map
  GoalBlocked,   ///< the body at the goal touches an obstacle, or leaves the map
  NoPath,        ///< the search has seen every state that it can reach
  GaveUp,        ///< the search has expanded as many states as it may
};

[[nodiscard]] const char* to_text(BodyPathStatus status) noexcept;

struct BodyPathResult {
  BodyPathStatus status = BodyPathStatus::NoPath;
  MotionPath path;      ///< from start to goal, exact; empty unless Found
  double margin = 0.0;  ///< the clearance that the whole path keeps [m]
  int expanded = 0;     ///< states expanded in all searches

  /// The status as a sentence, with figures.
  [[nodiscard]] std::string reason() const;
};

/// Searches a path for a body on a base, from pose to pose.
///
/// Two hybrid A* searches take turns, one from each end. The narrow end of a path is easier to
/// leave than to find. Every motion is proven free by BodyClearance. Deterministic; no clock.
/// @pre the base is valid.
[[nodiscard]] BodyPathResult plan_body_path(const BodyClearance& clearance,
                                            const BaseModel& base,
                                            const Pose2& start,
                                            const Pose2& goal,
                                            const BodyPathSettings& settings);

}  // namespace fairway
