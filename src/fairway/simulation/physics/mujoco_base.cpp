// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/physics/mujoco_base.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "fairway/geometry/angle.hpp"
#include "fairway/simulation/physics/mujoco_walls.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kGap = 0.04;     // between chassis and floor [m]
constexpr double kHeight = 0.25;  // of the chassis [m]
constexpr double kLift = 0.0005;  // what rolls starts this much above the floor [m]

// The outline as prisms and cylinders. @return the meshes that the prisms use.
std::string add_outline(std::ostream& xml, const BodyShape& body) {
  std::ostringstream meshes;
  meshes.precision(17);
  const auto parts = body.parts();
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const ConvexPart& part = parts[p];
    constexpr const char* kOutline = "' mass='0' contype='2' conaffinity='2' pos='";
    if (part.count > 2) {
      meshes << "<mesh name='part" << p << "' vertex='";
      for (int i = 0; i < part.count; ++i) {
        const Vector2d& at = part.vertex(i);
        meshes << at.x() << ' ' << at.y() << ' ' << -0.5 * kHeight << "  " << at.x() << ' '
               << at.y() << ' ' << 0.5 * kHeight << "  ";
      }
      meshes << "'/>\n";
      // MuJoCo moves a mesh to its own centre and back, so its place stays as written.
      xml << "<geom type='mesh' mesh='part" << p << kOutline << "0 0 " << kGap + 0.5 * kHeight
          << "'/>\n";
    }
    if (part.radius <= 0.0) continue;
    for (int i = 0; i < part.count; ++i)
      xml << "<geom type='cylinder' size='" << part.radius << ' ' << 0.5 * kHeight << kOutline
          << part.vertex(i).x() << ' ' << part.vertex(i).y() << ' ' << kGap + 0.5 * kHeight
          << "'/>\n";
  }
  return meshes.str();
}

// Rollers in the shape of barrels, so that the wheel is round.
void add_rollers(std::ostream& xml, double radius, double lateral) {
  constexpr int kRollers = 12;
  const double thick = 0.25 * radius;
  const double centre = radius - thick;
  const double half = std::sqrt(2.0 * thick * centre);
  for (int i = 0; i < kRollers; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kRollers;
    const double s = std::sin(angle);
    const double c = std::cos(angle);
    std::ostringstream axis;
    axis.precision(17);
    axis << c << ' ' << lateral << ' ' << s;
    xml << "<body pos='" << centre * s << " 0 " << -centre * c << "'>\n<joint axis='" << axis.str()
        << "' damping='0.0001' armature='0.0005'/>\n<geom type='ellipsoid' size='" << thick << ' '
        << thick << ' ' << half << "' zaxis='" << axis.str()
        << "' mass='0.05' contype='1' conaffinity='0' friction='1 0.005 0.0001'/>\n</body>\n";
  }
}

void add_wheel(std::ostream& xml,
               const MujocoBase& built,
               const MujocoWheel& wheel,
               std::size_t number) {
  const double r = built.wheel_radius;
  const double inertia = 0.002 * built.mass * r;
  constexpr double kServo = 60.0;  // natural frequency of the steering [rad/s]
  xml << "<body pos='" << wheel.at.x() << ' ' << wheel.at.y() << ' ' << r << "'>\n";
  // The steering carries the wheel, so it has some mass of its own.
  if (wheel.steered) {
    xml << "<inertial pos='0 0 0' mass='0.5' diaginertia='0.01 0.01 0.01'/>\n<joint name='steer"
        << number << "' axis='0 0 1' armature='" << inertia << "' damping='"
        << 2.0 * kServo * inertia << "'/>\n<body>\n";
  }
  xml << "<joint name='drive" << number << "' axis='0 1 0' armature='" << 0.05 * built.mass * r * r
      << "'/>\n";
  if (wheel.rollers != 0.0) {
    xml << "<geom type='cylinder' size='" << 0.5 * r << " 0.01' quat='0.70710678118654757 "
        << "0.70710678118654757 0 0' mass='1' contype='0' conaffinity='0'/>\n";
    add_rollers(xml, r, wheel.rollers);
  } else {
    xml << "<geom type='cylinder' size='" << r
        << " 0.005' quat='0.70710678118654757 0.70710678118654757 0 0' mass='0.5' contype='1' "
           "conaffinity='1' priority='1' friction='1 0.005 0.0001'/>\n";
  }
  if (wheel.steered) xml << "</body>\n";
  xml << "</body>\n";
}

void add_casters(std::ostream& xml, const BodyShape& body) {
  constexpr double kCaster = 0.019;  // radius: its lowest point is just above the floor [m]
  for (const double x : {0.95 * body.low().x(), 0.95 * body.high().x()}) {
    if (std::abs(x) < 0.05) continue;
    xml << "<geom type='sphere' size='" << kCaster << "' mass='0.05' pos='" << x << " 0 " << 0.02
        << "' condim='1' priority='1' contype='1' conaffinity='1'/>\n";
  }
}

}  // namespace

MujocoBase mujoco_base(const RobotModel& robot) {
  const BodyShape& body = robot.body;
  const BaseModel& base = robot.base;
  const Vector2d size = body.high() - body.low();
  MujocoBase built;
  built.wheel_radius = std::clamp(0.07 * size.x(), 0.08, 0.35);
  built.mass = 80.0 * size.x() * size.y();
  const double half = 0.4 * size.y();
  switch (base.kind) {
    case BaseKind::Unicycle: {
      const bool known = base.wheels.kind == WheelKind::Differential;
      const double at = known ? 0.5 * base.wheels.track : half;
      for (const double side : {1.0, -1.0})
        built.wheels.push_back({.at = {0.0, side * at}, .driven = true});
      break;
    }
    case BaseKind::Car:
      for (const double side : {1.0, -1.0}) {
        built.wheels.push_back({.at = {0.0, side * half}, .driven = true});
        built.wheels.push_back({.at = {base.wheelbase, side * half}, .steered = true});
      }
      built.centre = {0.45 * base.wheelbase, 0.0};
      break;
    case BaseKind::Tricycle:
      built.wheels.push_back({.at = {base.wheelbase, 0.0}, .steered = true, .driven = true});
      for (const double side : {1.0, -1.0})
        built.wheels.push_back({.at = {0.0, side * half}});
      built.centre = {0.45 * base.wheelbase, 0.0};
      break;
    case BaseKind::Omni:
      if (base.wheels.kind == WheelKind::Swerve) {
        for (int i = 0; i < base.wheels.num_modules; ++i)
          built.wheels.push_back({.at = base.wheels.modules[static_cast<std::size_t>(i)],
                                  .steered = true,
                                  .driven = true});
        break;
      }
      for (const double x : {1.0, -1.0}) {
        for (const double y : {1.0, -1.0}) {
          const double sum =
              base.wheels.kind == WheelKind::Mecanum ? base.wheels.half_sum : 0.4 * size.sum();
          built.wheels.push_back(
              {.at = {x * std::max(0.1, sum - half), y * half}, .driven = true, .rollers = -x * y});
        }
      }
      break;
  }
  return built;
}

WheelTarget wheel_target(const RobotModel& robot,
                         const MujocoWheel& wheel,
                         const PlanarTwist& twist,
                         double steering,
                         double angle) noexcept {
  // The velocity of the place above the wheel.
  const Vector2d v(twist.linear - twist.angular * wheel.at.y(),
                   twist.lateral + twist.angular * wheel.at.x());
  if (wheel.rollers != 0.0) return {.angle = 0.0, .speed = v.x() + wheel.rollers * v.y()};
  if (!wheel.steered) return {.angle = 0.0, .speed = v.x()};
  if (is_steered(robot.base)) {
    // Every wheel looks across the line to the centre of the turn, which the steering angle gives.
    const double curvature = std::tan(steering) / robot.base.wheelbase;
    const double turned = std::atan2(curvature * wheel.at.x(), 1.0 - curvature * wheel.at.y());
    return {.angle = turned, .speed = std::cos(turned) * v.x() + std::sin(turned) * v.y()};
  }
  constexpr double kSlow = 1e-3;  // at standstill a module stays as it is [m/s]
  if (v.norm() < kSlow) return {.angle = angle, .speed = 0.0};
  double turn = shortest_turn(angle, std::atan2(v.y(), v.x()));
  double speed = v.norm();
  if (std::abs(turn) > 0.5 * std::numbers::pi) {
    turn -= std::copysign(std::numbers::pi, turn);
    speed = -speed;
  }
  // While it turns it does not push aside.
  return {.angle = angle + turn, .speed = speed * std::max(0.0, std::cos(turn))};
}

std::string mujoco_base_model(const RobotModel& robot,
                              const MujocoBase& built,
                              const BitGrid& obstacles,
                              const Pose2& start) {
  std::ostringstream body;
  body.precision(17);
  body << "<body name='robot' pos='" << start.position.x() << ' ' << start.position.y() << ' '
       << kLift << "' quat='" << turn_about_vertical(start.heading) << "'>\n<freejoint/>\n";
  const std::string meshes = add_outline(body, robot.body);
  const Vector2d size = robot.body.high() - robot.body.low();
  body << "<geom type='box' mass='" << built.mass << "' contype='0' conaffinity='0' pos='"
       << built.centre.x() << ' ' << built.centre.y() << ' ' << kGap + 0.3 * kHeight << "' size='"
       << 0.3 * size.x() << ' ' << 0.4 * size.y() << ' ' << 0.3 * kHeight << "'/>\n";
  if (robot.base.kind == BaseKind::Unicycle) add_casters(body, robot.body);
  for (std::size_t i = 0; i < built.wheels.size(); ++i)
    add_wheel(body, built, built.wheels[i], i);
  body << "</body>\n";

  // Not the implicit integrator: with it MuJoCo 2.2 lets wheels slip ahead of a base that speeds
  // up.
  std::ostringstream xml;
  xml.precision(17);
  xml << "<mujoco model='fairway'>\n"
         "<option timestep='0.0025' noslip_iterations='4'/>\n"
         "<asset>\n"
      << meshes << "</asset>\n<worldbody>\n"
      << "<geom name='floor' type='plane' size='0 0 1' contype='1' conaffinity='1'/>\n";
  write_walls(xml, obstacles, "");
  xml << body.str() << "</worldbody>\n<actuator>\n";
  const double r = built.wheel_radius;
  const double inertia = 0.002 * built.mass * r;
  for (std::size_t i = 0; i < built.wheels.size(); ++i) {
    if (built.wheels[i].steered)
      xml << "<position name='steer" << i << "' joint='steer" << i << "' kp='" << 3600.0 * inertia
          << "'/>\n";
    if (built.wheels[i].driven)
      xml << "<velocity name='drive" << i << "' joint='drive" << i << "' kv='"
          << 20.0 * built.mass * r * r << "' forcelimited='true' forcerange='"
          << -6.0 * built.mass * r << ' ' << 6.0 * built.mass * r << "'/>\n";
  }
  xml << "</actuator>\n</mujoco>\n";
  return xml.str();
}

}  // namespace fairway
