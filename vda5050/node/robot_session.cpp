// SPDX-License-Identifier: Apache-2.0
#include "node/robot_session.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

namespace fairway::vda5050 {

namespace {

Vehicle make_vehicle(const SessionContext& context, const VehicleIdentity& identity) {
  VehicleDescription description;
  description.robot = context.settings.robot;
  // An event must be published within 20 ms; events of one cycle are bundled anyway.
  description.least_state_interval = 0.01;
  return {identity, description, context.map_id};
}

double wall_clock() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace

RobotSession::RobotSession(const SessionContext& context,
                           std::size_t robot,
                           const VehicleIdentity& identity)
    : context_(context),
      robot_(robot),
      vehicle_(make_vehicle(context, identity)),
      driver_(context.settings, context.map),
      connection_(context.broker,
                  identity,
                  vehicle_.connection_message(ConnectionState::Broken, wall_clock()),
                  context.wakeup) {
  context_.bases.attach(robot_, driver_);
  vehicle_.set_route_check([this](const Route& route, const std::vector<Zone>& zones) {
    return driver_.first_closed(route, zones);
  });
  vehicle_.set_pose_setter([this](const Pose2& pose) {
    if (!context_.bases.place(robot_, pose)) return false;
    driver_.restart();
    return true;
  });
}

void RobotSession::handle_events(double now) {
  const std::vector<BrokerEvent> events = connection_.take_events();
  for (const BrokerEvent& event : events) {
    switch (event.kind) {
      case BrokerEvent::Kind::Ready:
        vehicle_.announce(now);
        break;
      case BrokerEvent::Kind::Lost:
        std::fprintf(
            stderr, "fairway: %s: the broker is lost; the robot drives on to the end of its base\n",
            vehicle_.identity().serial.c_str());
        break;
      case BrokerEvent::Kind::Refused:
        std::fprintf(stderr, "fairway: %s: the broker refuses the connection: %s\n",
                     vehicle_.identity().serial.c_str(), event.payload.c_str());
        break;
      case BrokerEvent::Kind::Message:
        vehicle_.receive(event.topic, event.payload, now);
        break;
    }
  }
  if (!events.empty() || vehicle_.owes_state()) publish(now);
}

void RobotSession::note_motion(const DrivenRoute& driven, const SensedRobot& sensed, double now) {
  constexpr double kStands = 5e-3;  // [m/s] and [rad/s], above the noise of odometry
  const Pose2& pose = sensed.measured.pose;
  VehicleMotion motion;
  motion.pose = pose;
  motion.twist = sensed.twist;
  motion.localized = sensed.localized;
  const auto moves = [](const Twist2& twist) {
    return std::abs(twist.linear) > kStands || std::abs(twist.angular) > kStands;
  };
  motion.driving = moves(sensed.twist) || moves(driven.command);
  if (vehicle_.may_drive() && driven.limit != LimitingFactor::None)
    motion.limit = std::string(to_text(driven.status)) + ", limited by " + to_text(driven.limit);
  motion.planned = driver_.planned(pose.position);
  motion.intermediate.push_back({.pose = pose, .time = now});
  if (driven.solution != nullptr && vehicle_.may_drive()) {
    const double step = context_.settings.mpc.step_length / context_.speed;
    for (int k = 1; k <= driven.solution->horizon; ++k) {
      motion.intermediate.push_back(
          {.pose = driven.solution->poses.at(static_cast<std::size_t>(k)), .time = now + k * step});
    }
  }
  vehicle_.update(motion, driven.report, now);
}

void RobotSession::cycle(double now) {
  const SensedRobot sensed = context_.bases.measure(robot_);
  const DrivenRoute driven = driver_.drive(vehicle_, sensed.measured);
  context_.bases.command(robot_, driven.command, vehicle_.may_drive());
  note_motion(driven, sensed, now);
  publish(now);
}

bool RobotSession::brake() {
  const SensedRobot sensed = context_.bases.measure(robot_);
  const Twist2 command = driver_.brake(sensed.measured);
  context_.bases.command(robot_, command, true);
  return command.linear == 0.0 && command.angular == 0.0;
}

void RobotSession::publish(double now) {
  if (!connection_.connected()) return;  // the state is sent when the broker is back
  for (const OutgoingMessage& message : vehicle_.take_messages(now))
    connection_.publish(message);
}

void RobotSession::finish(double now, double seconds) {
  connection_.finish(vehicle_.connection_message(ConnectionState::Offline, now), seconds);
}

}  // namespace fairway::vda5050
