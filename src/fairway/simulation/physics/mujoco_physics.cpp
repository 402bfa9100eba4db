// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/physics/mujoco_physics.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <mujoco/mujoco.h>

#include "fairway/base/contract.hpp"
#include "fairway/geometry/angle.hpp"
#include "fairway/simulation/physics/mujoco_loading.hpp"

namespace fairway {

namespace {

constexpr int kMustNotTouch = 2;         // contype in the model
constexpr double kLongestStep = 0.0025;  // [s]

}  // namespace

void MujocoPhysics::DeleteModel::operator()(mjModel_* model) const noexcept {
  mj_deleteModel(model);
}
void MujocoPhysics::DeleteData::operator()(mjData_* data) const noexcept { mj_deleteData(data); }

MujocoPhysics::MujocoPhysics(const Scenario& scenario, const MujocoRobot& robot)
    : robot_(robot),
      wheel_base_(wheel_base_of(robot, scenario.settings.robot)),
      ramped_(scenario.robots.size()),
      controllers_(scenario.robots.size()),
      model_(load_mujoco_model(mujoco_model(scenario, robot))),
      data_(mj_makeData(model_.get())) {
  geom_robot_.assign(static_cast<std::size_t>(model_->ngeom), -1);
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    const std::string number = std::to_string(i);
    robot_body_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, ("robot" + number).c_str()));
    // Its chassis is all of it that must not touch; the wheels are bodies of their own.
    for (int geom = 0; geom < model_->ngeom; ++geom) {
      const bool chassis = model_->geom_contype[geom] == kMustNotTouch;
      if (chassis && model_->geom_bodyid[geom] == robot_body_.back())
        geom_robot_[static_cast<std::size_t>(geom)] = static_cast<int>(i);
    }
  }
  mj_forward(model_.get(), data_.get());
}

MujocoPhysics::~MujocoPhysics() = default;

void MujocoPhysics::advance(std::span<const Twist2> commands,
                            MovingObstacles bodies,
                            double dt,
                            std::vector<UnicycleRobot>& robots,
                            std::vector<std::uint8_t>& touched) {
  FAIRWAY_EXPECTS(commands.size() == ramped_.size());
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / kLongestStep - 1e-9)));
  model_->opt.timestep = dt / steps;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    data_->mocap_pos[3 * i] = bodies[i].position.x();
    data_->mocap_pos[3 * i + 1] = bodies[i].position.y();
  }
  for (int n = 0; n < steps; ++n) {
    ramp(commands, robots, dt / steps);
    mj_step(model_.get(), data_.get());
    note_contacts(touched);
  }
  read(robots);
}

void MujocoPhysics::ramp(std::span<const Twist2> commands,
                         const std::vector<UnicycleRobot>& robots,
                         double dt) noexcept {
  for (std::size_t i = 0; i < commands.size(); ++i) {
    ramped_[i] = controllers_[i].follow(ramped_[i], commands[i], robots[i].limits, dt);
    const double across = 0.5 * wheel_base_ * ramped_[i].angular;
    data_->ctrl[2 * i] = (ramped_[i].linear - across) / robot_.wheel_radius;
    data_->ctrl[2 * i + 1] = (ramped_[i].linear + across) / robot_.wheel_radius;
  }
}

void MujocoPhysics::read(std::vector<UnicycleRobot>& robots) const {
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const auto body = static_cast<std::size_t>(robot_body_[i]);
    const mjtNum* position = data_->xpos + 3 * body;
    const mjtNum* axes = data_->xmat + 9 * body;  // row by row; the first column is forward
    Pose2& pose = robots[i].pose;
    pose.position = {position[0], position[1]};
    pose.heading = std::atan2(axes[3], axes[0]);
    const mjtNum* speed = data_->qvel + model_->body_dofadr[body];
    robots[i].twist = {.linear = Eigen::Vector2d(speed[0], speed[1]).dot(direction(pose.heading)),
                       .angular = speed[5]};
  }
}

void MujocoPhysics::note_contacts(std::vector<std::uint8_t>& touched) const {
  for (int c = 0; c < data_->ncon; ++c) {
    for (const int geom : {data_->contact[c].geom1, data_->contact[c].geom2}) {
      const int robot = geom_robot_[static_cast<std::size_t>(geom)];
      if (robot >= 0) touched[static_cast<std::size_t>(robot)] = 1;
    }
  }
}

std::unique_ptr<Physics> make_mujoco_physics(const Scenario& scenario) {
  return std::make_unique<MujocoPhysics>(scenario);
}

}  // namespace fairway
