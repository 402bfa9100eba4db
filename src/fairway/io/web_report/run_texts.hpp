// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "fairway/simulation/scenario.hpp"

namespace fairway::io {

/// Returns the settings as a list of {group, name, unit, meaning, min, max, value, kind, choices}.
/// The page makes tables and sliders from it. `kind` is number, integer, switch or choice; min and
/// max are omitted where there is no limit.
[[nodiscard]] nlohmann::json settings_list(const Settings& settings);

/// JSON that begins a run in `RunStream`.
[[nodiscard]] std::string begin_text(const Scenario& scenario);

/// JSON that announces the robots of a running world.
[[nodiscard]] std::string robots_text(double time, std::span<const RobotTask> robots);

/// JSON that announces the zones that hold from now on.
[[nodiscard]] std::string zones_text(double time, const Zones& zones);

/// JSON that announces changed settings.
[[nodiscard]] std::string tuning_text(double time, const Settings& settings);

}  // namespace fairway::io
