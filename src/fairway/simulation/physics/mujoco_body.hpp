// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "fairway/simulation/bodies/body_robot.hpp"
#include "fairway/simulation/physics/mujoco_base.hpp"

struct mjData_;   // NOLINT(readability-identifier-naming): MuJoCo's names
struct mjModel_;  // NOLINT(readability-identifier-naming)

namespace fairway {

/// One robot on any base as rigid bodies on wheels, moved by MuJoCo among the cells of a map.
///
/// The base's own controller ramps commands within the limits of the base. Motors, servos, wheels
/// and floor determine the resulting motion.
class MujocoBody {
 public:
  /// @throws std::runtime_error with MuJoCo's words when it does not accept the model.
  MujocoBody(const RobotModel& robot, const BitGrid& obstacles, const Pose2& start);
  ~MujocoBody();
  MujocoBody(const MujocoBody&) = delete;
  MujocoBody& operator=(const MujocoBody&) = delete;

  /// Moves for `dt` [s] under a command.
  void advance(const BaseInput& command, double dt);

  [[nodiscard]] Pose2 pose() const;
  [[nodiscard]] PlanarTwist twist() const;  ///< in its own frame

  /// Whether it has touched an obstacle.
  [[nodiscard]] bool touched() const noexcept { return touched_; }

 private:
  struct DeleteModel {
    void operator()(mjModel_* model) const noexcept;
  };
  struct DeleteData {
    void operator()(mjData_* data) const noexcept;
  };
  struct Wheel {
    int angle = -1;  // index of the joint's position
    int steer = -1;  // index of the actuator
    int drive = -1;  // index of the actuator
  };

  void command_wheels() noexcept;
  void note_contacts() noexcept;

  BodyRobot ramp_;  // what the base's controller asks of the wheels; its pose is not used
  MujocoBase built_;
  int body_ = 0;
  bool touched_ = false;
  std::vector<Wheel> wheels_;
  std::unique_ptr<mjModel_, DeleteModel> model_;
  std::unique_ptr<mjData_, DeleteData> data_;
};

}  // namespace fairway
