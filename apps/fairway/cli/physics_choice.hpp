// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/bodies/body_drive.hpp"
#include "fairway/base/error.hpp"
#include "fairway/simulation/physics.hpp"

namespace fairway::app {

/// The engine of that name: "unicycle" (an empty maker) or "mujoco"; an error if the tool was built
/// without it.
[[nodiscard]] Expected<PhysicsMaker> choose_physics(const std::string& name);

/// The same for the tasks of `fairway bodies`, with a model of each base.
[[nodiscard]] Expected<BodyPlantMaker> choose_body_plant(const std::string& name);

}  // namespace fairway::app
