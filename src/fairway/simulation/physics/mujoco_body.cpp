// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/physics/mujoco_body.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <mujoco/mujoco.h>

#include "fairway/simulation/physics/mujoco_loading.hpp"

namespace fairway {

void MujocoBody::DeleteModel::operator()(mjModel_* model) const noexcept { mj_deleteModel(model); }
void MujocoBody::DeleteData::operator()(mjData_* data) const noexcept { mj_deleteData(data); }

MujocoBody::MujocoBody(const RobotModel& robot, const BitGrid& obstacles, const Pose2& start)
    : ramp_{.model = robot, .pose = {}},
      built_(mujoco_base(robot)),
      model_(load_mujoco_model(mujoco_base_model(robot, built_, obstacles, start))),
      data_(mj_makeData(model_.get())) {
  body_ = mj_name2id(model_.get(), mjOBJ_BODY, "robot");
  for (std::size_t i = 0; i < built_.wheels.size(); ++i) {
    const std::string number = std::to_string(i);
    Wheel wheel;
    const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, ("steer" + number).c_str());
    if (joint >= 0) wheel.angle = model_->jnt_qposadr[joint];
    wheel.steer = mj_name2id(model_.get(), mjOBJ_ACTUATOR, ("steer" + number).c_str());
    wheel.drive = mj_name2id(model_.get(), mjOBJ_ACTUATOR, ("drive" + number).c_str());
    wheels_.push_back(wheel);
  }
  mj_forward(model_.get(), data_.get());
}

MujocoBody::~MujocoBody() = default;

void MujocoBody::command_wheels() noexcept {
  const PlanarTwist twist = ramp_.twist();
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const Wheel& wheel = wheels_[i];
    const double angle = wheel.angle >= 0 ? data_->qpos[wheel.angle] : 0.0;
    const WheelTarget target =
        wheel_target(ramp_.model, built_.wheels[i], twist, ramp_.input.turn, angle);
    if (wheel.steer >= 0) data_->ctrl[wheel.steer] = target.angle;
    if (wheel.drive >= 0) data_->ctrl[wheel.drive] = target.speed / built_.wheel_radius;
  }
}

void MujocoBody::note_contacts() noexcept {
  constexpr int kMustNotTouch = 2;  // contype in the model
  for (int c = 0; c < data_->ncon; ++c) {
    for (const int geom : {data_->contact[c].geom1, data_->contact[c].geom2}) {
      if (model_->geom_bodyid[geom] == body_ && model_->geom_contype[geom] == kMustNotTouch)
        touched_ = true;
    }
  }
}

void MujocoBody::advance(const BaseInput& command, double dt) {
  constexpr double kLongestStep = 0.0025;  // [s]
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / kLongestStep - 1e-9)));
  model_->opt.timestep = dt / steps;
  ramp_.sent = command;
  for (int n = 0; n < steps; ++n) {
    ramp_.advance(dt / steps);
    command_wheels();
    mj_step(model_.get(), data_.get());
    note_contacts();
  }
}

Pose2 MujocoBody::pose() const {
  const mjtNum* position = data_->xpos + 3 * body_;
  const mjtNum* axes = data_->xmat + 9 * body_;  // row by row; the first column is forward
  return {.position = {position[0], position[1]}, .heading = std::atan2(axes[3], axes[0])};
}

PlanarTwist MujocoBody::twist() const {
  const mjtNum* speed = data_->qvel + model_->body_dofadr[body_];
  const Eigen::Vector2d local = rotated({speed[0], speed[1]}, -pose().heading);
  return {.linear = local.x(), .lateral = local.y(), .angular = speed[5]};
}

}  // namespace fairway
