// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "bases/simulated_fleet.hpp"
#include "driver/route_driver.hpp"
#include "fleet_double.hpp"

namespace fairway::vda5050::test {

/// A robot of the simulator with its vehicle and driver, without a broker.
class SimulatedRun {
 public:
  /// @param known  The map of the driver, where it differs from the world.
  SimulatedRun(ProtocolVersion version,
               const Pose2& start,
               const OccupancyGrid& world,
               Sensing sensing = Sensing::Map,
               const std::optional<OccupancyGrid>& known = {},
               const std::string& map_id = "floor")
      : messages(version),
        vehicle({.version = version, .interface_name = {}}, {}, map_id),
        fleet_(scenario(world, sensing, start), {}),
        driver_({}, BitGrid(known.value_or(world))) {
    vehicle.set_route_check([this](const Route& route, const std::vector<Zone>& zones) {
      return driver_.first_closed(route, zones);
    });
    fleet_.attach(0, driver_);
    cycle();
  }

  void send(Topic topic, const json& message) { vehicle.receive(topic, message.dump(), time_); }

  void cycle() {
    const Measurements measured = fleet_.measure(0).measured;
    const DrivenRoute driven = driver_.drive(vehicle, measured);
    fleet_.command(0, driven.command, vehicle.may_drive());
    VehicleMotion motion;
    motion.pose = measured.pose;
    motion.twist = fleet_.robot(0).twist;
    motion.driving = std::abs(motion.twist.linear) > 1e-3 ||
                     std::abs(motion.twist.angular) > 1e-3 ||
                     std::abs(driven.command.linear) > 1e-3;
    const bool was_driving = driving_;
    driving_ = motion.driving;
    if (was_driving && !driving_) ++stops;
    vehicle.update(motion, driven.report, time_);
    note_place(measured.pose.position);
    speeds.push_back(motion.twist.linear);
    fleet_.advance(kPeriod);
    time_ += kPeriod;
  }

  /// How far the robot was outside of the strips of its edge, at most; within 0.4 m of a node the
  /// strip of either edge counts [m].
  double outside = 0.0;

  /// Runs until `done` holds; fails after `seconds`.
  template <typename Done>
  void until(Done&& done, double seconds = 60.0) {
    for (double t = 0.0; t < seconds; t += kPeriod) {
      cycle();
      if (done()) return;
    }
    const Eigen::Vector2d at = places.back();
    const auto errors = vehicle.state().errors;
    FAIL() << "not within " << seconds << " s; the robot is at (" << at.x() << ", " << at.y()
           << "), " << (errors.empty() ? std::string("no error") : errors[0].description);
  }
  void until_idle() {
    until([&] { return vehicle.idle() && !driving_; });
  }

  [[nodiscard]] bool driving() const noexcept { return driving_; }

  /// How far the robot was beside the x axis, at most.
  [[nodiscard]] double widest() const {
    double most = 0.0;
    for (const Eigen::Vector2d& place : places)
      most = std::max(most, std::abs(place.y()));
    return most;
  }
  [[nodiscard]] double furthest() const {
    double most = -1e9;
    for (const Eigen::Vector2d& place : places)
      most = std::max(most, place.x());
    return most;
  }
  [[nodiscard]] bool has_error(Fault fault) const {
    const auto errors = vehicle.state().errors;
    return std::any_of(errors.begin(), errors.end(), [&](const VehicleError& error) {
      return error.type == messages.type(fault);
    });
  }

  FleetDouble messages;
  Vehicle vehicle;
  std::vector<Eigen::Vector2d> places;
  std::vector<double> speeds;
  int stops = 0;

 private:
  // The check of a fleet control: with the lines and widths of the released edges.
  void note_place(const Eigen::Vector2d& place) {
    places.push_back(place);
    std::vector<RouteLeg> legs = vehicle.order().legs;
    legs.resize(std::min(legs.size(), vehicle.order().released_nodes()));
    if (!legs.empty() && legs[0].edge_sequence != sequence_) {
      before_ = current_;
      current_ = legs[0];
      sequence_ = legs[0].edge_sequence;
    }
    double least = std::numeric_limits<double>::infinity();
    constexpr double kNear = 0.4;  // [m]
    if (!legs.empty()) {
      least = outside_by(legs[0], place, 0.25);
      if (legs.size() > 1 && (legs[0].end.position - place).norm() < kNear)
        least = std::min(least, outside_by(legs[1], place, 0.25));
    } else if (current_) {
      least = outside_by(*current_, place, 0.25);  // stopped at the end of the base
    }
    // A vehicle may begin beside its strip, inside the ellipse of its first node.
    if (!before_ && current_ && ellipse_distance(current_->start, place) <= 1.0) least = 0.0;
    if (before_ && (before_->end.position - place).norm() < kNear)
      least = std::min(least, outside_by(*before_, place, 0.25));
    if (std::isfinite(least)) outside = std::max(outside, least);
  }

  static constexpr double kPeriod = 0.1;  // [s]
  std::optional<RouteLeg> before_;
  std::optional<RouteLeg> current_;
  std::uint32_t sequence_ = 0;

  static Scenario scenario(const OccupancyGrid& world, Sensing sensing, const Pose2& start) {
    Scenario scenario;
    scenario.map = world;
    scenario.sensing.sensing = sensing;
    scenario.robots = {{.name = "robot", .start = start, .goal = {}}};
    return scenario;
  }

  SimulatedFleet fleet_;
  RouteDriver driver_;
  bool driving_ = false;
  double time_ = 1.8e9;
};

}  // namespace fairway::vda5050::test
