// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <nlohmann/json.hpp>

#include "fairway/simulation/world.hpp"

namespace fairway::io {

/// The robots of a `fairway.Scenario`.
[[nodiscard]] nlohmann::json robots_json(std::span<const RobotTask> tasks);

/// The contact of a robot in a `fairway.World`.
[[nodiscard]] nlohmann::json contact_json(const Encounter& met);

/// Where a body that reacts to robots walks.
[[nodiscard]] nlohmann::json walk_plan_json(const WalkPlan& plan);
[[nodiscard]] WalkPlan to_walk_plan(const nlohmann::json& json);

}  // namespace fairway::io
