// SPDX-License-Identifier: Apache-2.0
#include "cli/physics_choice.hpp"

#include "cli/left_out.hpp"

#ifdef FAIRWAY_WITH_MUJOCO
#include "fairway/map/bit_grid.hpp"
#include "fairway/simulation/physics/mujoco_body.hpp"
#include "fairway/simulation/physics/mujoco_physics.hpp"
#endif

namespace fairway::app {

namespace {

Error no_engine(const std::string& name) {
  return {"--physics: expected unicycle, found " + name + ", " +
          left_out("libmujoco-dev libqhull-dev libosmesa6-dev")};
}

#ifdef FAIRWAY_WITH_MUJOCO
class MujocoPlant final : public BodyPlant {
 public:
  explicit MujocoPlant(const BodyTask& task)
      : body_({.body = task.body, .base = task.base}, BitGrid(task.map), task.start) {}

  void advance(const BaseInput& command, double dt) override { body_.advance(command, dt); }
  [[nodiscard]] Pose2 pose() const override { return body_.pose(); }
  [[nodiscard]] bool touched() const override { return body_.touched(); }

 private:
  MujocoBody body_;
};
#endif

}  // namespace

Expected<PhysicsMaker> choose_physics(const std::string& name) {
  if (name == "unicycle") return PhysicsMaker();
#ifdef FAIRWAY_WITH_MUJOCO
  if (name == "mujoco") return PhysicsMaker(make_mujoco_physics);
#endif
  return tl::unexpected(no_engine(name));
}

Expected<BodyPlantMaker> choose_body_plant(const std::string& name) {
  if (name == "unicycle") return BodyPlantMaker();
#ifdef FAIRWAY_WITH_MUJOCO
  if (name == "mujoco") {
    return BodyPlantMaker([](const BodyTask& task) -> std::unique_ptr<BodyPlant> {
      return std::make_unique<MujocoPlant>(task);
    });
  }
#endif
  return tl::unexpected(no_engine(name));
}

}  // namespace fairway::app
