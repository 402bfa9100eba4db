// SPDX-License-Identifier: Apache-2.0
#include "cli/physics_choice.hpp"

#include "cli/left_out.hpp"

#ifdef FAIRWAY_WITH_MUJOCO
#include "fairway/simulation/physics/mujoco_physics.hpp"
#endif

namespace fairway::app {

Expected<PhysicsMaker> choose_physics(const std::string& name) {
  if (name == "unicycle") return PhysicsMaker();
#ifdef FAIRWAY_WITH_MUJOCO
  if (name == "mujoco") return PhysicsMaker(make_mujoco_physics);
#endif
  return fail("--physics: expected unicycle, found " + name + ", " +
              left_out("libmujoco-dev libqhull-dev libosmesa6-dev"));
}

}  // namespace fairway::app
