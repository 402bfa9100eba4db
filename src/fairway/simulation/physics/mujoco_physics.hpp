// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "fairway/simulation/physics.hpp"
#include "fairway/simulation/physics/mujoco_model.hpp"

struct mjData_;   // NOLINT(readability-identifier-naming): MuJoCo's names
struct mjModel_;  // NOLINT(readability-identifier-naming)

namespace fairway {

/// The robots of a scenario as rigid bodies on driven wheels, moved by MuJoCo.
///
/// The base's own controller follows a command with its delay, lag and acceleration limits, as the
/// unicycle's does. Motors, wheels and floor determine the resulting motion.
class MujocoPhysics final : public Physics {
 public:
  /// @throws std::runtime_error with MuJoCo's words when it does not accept the model.
  explicit MujocoPhysics(const Scenario& scenario, const MujocoRobot& robot = {});
  ~MujocoPhysics() override;

  void advance(std::span<const Twist2> commands,
               MovingObstacles bodies,
               double dt,
               std::vector<UnicycleRobot>& robots,
               std::vector<std::uint8_t>& touched) override;

  /// For pictures; valid while this lives.
  [[nodiscard]] const mjModel_* model() const noexcept { return model_.get(); }
  [[nodiscard]] mjData_* data() const noexcept { return data_.get(); }

 private:
  struct DeleteModel {
    void operator()(mjModel_* model) const noexcept;
  };
  struct DeleteData {
    void operator()(mjData_* data) const noexcept;
  };

  void ramp(std::span<const Twist2> commands,
            const std::vector<UnicycleRobot>& robots,
            double dt) noexcept;
  void read(std::vector<UnicycleRobot>& robots) const;
  void note_contacts(std::vector<std::uint8_t>& touched) const;

  MujocoRobot robot_;
  double wheel_base_;
  std::vector<Twist2> ramped_;  // what the base's controller asks of the wheels
  std::vector<BaseController> controllers_;
  std::vector<int> robot_body_;  // per robot, MuJoCo's number of its body
  std::vector<int> geom_robot_;  // per geom, the robot whose chassis it is; -1 for none
  std::unique_ptr<mjModel_, DeleteModel> model_;
  std::unique_ptr<mjData_, DeleteData> data_;
};

/// What World asks for: a PhysicsMaker.
[[nodiscard]] std::unique_ptr<Physics> make_mujoco_physics(const Scenario& scenario);

}  // namespace fairway
