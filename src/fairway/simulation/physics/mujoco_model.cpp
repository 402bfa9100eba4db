// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/physics/mujoco_model.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "fairway/simulation/physics/mujoco_walls.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kGroundGap = 0.04;  // between chassis and floor [m]
constexpr double kLift = 0.001;      // what rolls starts this much above the floor [m]

// Returns half of the extent of a body of several discs along one axis. It counts the side of the
// robot's centre where the body reaches less; for another body it is half its side.
double half_side(const RobotSettings& body, int axis) {
  if (body.discs.count == 0) {
    const double side = axis == 0 ? body.length : body.width;
    return side > 0.0 ? 0.5 * side : body.radius;
  }
  double low = 0.0;
  double high = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(body.discs.count); ++i) {
    const Footprint::Disc& disc = body.discs.discs[i];
    low = std::max(low, disc.radius - disc.center[axis]);
    high = std::max(high, disc.radius + disc.center[axis]);
  }
  return std::max(std::min(low, high), BodyDiscs::kLeastRadius);
}

double robot_width(const RobotSettings& body) { return 2.0 * half_side(body, 1); }

double robot_length(const RobotSettings& body) { return 2.0 * half_side(body, 0); }

// Contact happens between what shares a bit: 1 is what rolls on the floor, 2 is what must not
// touch.
void add_world(std::ostream& xml, const Scenario& scenario) {
  const BitGrid obstacles(scenario.map, unknown_cells(scenario.settings.map));
  xml << "<geom name='floor' type='plane' size='0 0 1' contype='1' conaffinity='1' "
         "material='floor'/>\n";
  write_walls(xml, obstacles, " material='wall'");
}

// All of a robot that must not touch anything, and its mass.
void add_chassis(std::ostream& xml, const RobotSettings& body, const MujocoRobot& robot) {
  const double half_height = 0.5 * robot.height;
  const Footprint outline = footprint_of(body);
  const auto chassis = [&](const Vector2d& center, double mass) -> std::ostream& {
    return xml << "<geom mass='" << mass << "' contype='2' conaffinity='2' material='chassis' pos='"
               << center.x() << ' ' << center.y() << ' ' << kGroundGap + half_height << "' ";
  };
  if (outline.is_rectangle()) {
    chassis({0.0, 0.0}, robot.mass) << "type='box' size='" << 0.5 * body.length << ' '
                                    << 0.5 * body.width << ' ' << half_height << "'/>\n";
  }
  for (int i = 0; i < outline.num_discs(); ++i) {
    const Footprint::Disc& disc = outline.disc_at(i);
    chassis(disc.center, body.discs.count > 0 ? 0.0 : robot.mass)
        << "type='cylinder' size='" << disc.radius << ' ' << half_height << "'/>\n";
  }
  if (body.discs.count > 0) {
    // The mass is between the wheels, so that it does not tip over where most discs are.
    xml << "<geom type='box' mass='" << robot.mass
        << "' contype='0' conaffinity='0' rgba='0 0 0 0' pos='0 0 " << kGroundGap + half_height
        << "' size='" << 0.5 * robot_length(body) << ' ' << 0.5 * robot_width(body) << ' '
        << half_height << "'/>\n";
  }
}

void add_robot(std::ostream& xml,
               const RobotSettings& body,
               const MujocoRobot& robot,
               const RobotTask& task,
               std::size_t index) {
  const double half_base = 0.5 * wheel_base_of(robot, body);
  const double radius = robot.wheel_radius;
  const double caster = 0.5 * kGroundGap;
  const double caster_at = 0.4 * robot_length(body);
  const Vector2d& at = task.start.position;
  xml << "<body name='robot" << index << "' pos='" << at.x() << ' ' << at.y() << ' ' << kLift
      << "' quat='" << turn_about_vertical(task.start.heading) << "'>\n<freejoint/>\n";
  add_chassis(xml, body, robot);
  // Dark on top where it is in front: only to be seen.
  xml << "<geom type='box' mass='0' contype='0' conaffinity='0' material='wheel' pos='"
      << 0.25 * robot_length(body) << " 0 " << kGroundGap + robot.height << "' size='"
      << 0.08 * robot_length(body) << ' ' << 0.3 * robot_width(body) << " 0.01'/>\n";
  for (const double side : {1.0, -1.0}) {
    xml << "<geom type='sphere' size='" << caster << "' mass='0.05' pos='" << side * caster_at
        << " 0 " << caster << "' condim='1' priority='1' contype='1' conaffinity='1'/>\n";
    const char* name = side > 0.0 ? "left" : "right";
    xml << "<body pos='0 " << side * half_base << ' ' << radius << "'>\n<joint name='" << name
        << index << "' axis='0 1 0' armature='0.01'/>\n<geom type='cylinder' size='" << radius
        << ' ' << 0.5 * robot.wheel_width
        << "' quat='0.70710678118654757 0.70710678118654757 0 0' mass='0.5' contype='1' "
           "conaffinity='1' priority='1' material='wheel' friction='"
        << robot.wheel_friction << " 0.005 0.0001'/>\n</body>\n";
  }
  xml << "</body>\n";
}

}  // namespace

double wheel_base_of(const MujocoRobot& robot, const RobotSettings& body) noexcept {
  return robot.wheel_base > 0.0 ? robot.wheel_base : 0.9 * robot_width(body);
}

std::string mujoco_model(const Scenario& scenario, const MujocoRobot& robot) {
  std::ostringstream xml;
  xml.precision(17);
  xml << "<mujoco model='fairway'>\n"
         "<option timestep='0.0025' integrator='implicit' noslip_iterations='4'/>\n"
         "<visual><global offwidth='1280' offheight='720'/>\n"
         "<headlight ambient='0.4 0.4 0.4'/></visual>\n"
         "<asset><material name='floor' rgba='0.5 0.52 0.54 1' specular='0'/>\n"
         "<material name='wall' rgba='0.35 0.4 0.48 1'/>\n"
         "<material name='chassis' rgba='0.95 0.65 0.1 1'/>\n"
         "<material name='wheel' rgba='0.1 0.1 0.1 1'/>\n"
         "<material name='body' rgba='0.75 0.25 0.25 1'/></asset>\n"
         "<worldbody>\n<light pos='0 0 20' dir='0.2 0.3 -1' directional='true'/>\n";
  add_world(xml, scenario);
  for (std::size_t i = 0; i < scenario.bodies.size(); ++i) {
    const MovingObstacle body = scenario.bodies[i].at(0.0);
    xml << "<body name='body" << i << "' mocap='true' pos='" << body.position.x() << ' '
        << body.position.y() << ' ' << 0.5 * kWallHeight << "'><geom type='cylinder' size='"
        << body.radius << ' ' << 0.5 * kWallHeight
        << "' contype='2' conaffinity='2' material='body'/></body>\n";
  }
  for (std::size_t i = 0; i < scenario.robots.size(); ++i)
    add_robot(xml, scenario.settings.robot, robot, scenario.robots[i], i);
  xml << "</worldbody>\n<actuator>\n";
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    for (const char* side : {"left", "right"}) {
      xml << "<velocity joint='" << side << i << "' kv='" << robot.motor_gain
          << "' forcelimited='true' forcerange='" << -robot.motor_torque << ' '
          << robot.motor_torque << "'/>\n";
    }
  }
  xml << "</actuator>\n</mujoco>\n";
  return xml.str();
}

}  // namespace fairway
