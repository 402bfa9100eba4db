// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bases/robot_bases.hpp"
#include "bases/robot_link.hpp"
#include "bridge/command_guard.hpp"
#include "bridge/sensing/robot_senses.hpp"

namespace fairway::vda5050 {

/// What is fixed about robots behind a middleware.
struct LinkOptions {
  bool use_scan = true;     ///< scans are needed, and their age is checked
  bool use_monitor = true;  ///< check every command with a SafetyMonitor; needs scans
};

/// One robot behind a middleware.
class LinkedRobot : public bridge::SensorReceiver {
 public:
  /// @param number  In the fleet; see bridge::robot_number.
  LinkedRobot(const Settings& settings,
              const LinkOptions& options,
              std::uint32_t number,
              std::unique_ptr<RobotLink> link);

  void add_odometry(double time, const Pose2& pose, const PlanarTwist& twist) override {
    senses_.add_odometry(time, pose, twist);
  }
  void set_localisation(const Pose2& odometry_in_map, double time) override {
    senses_.set_localisation(odometry_in_map, time);
  }
  bool add_scan(LidarScan scan, double duration, const Pose2& sensor_on_robot) override;
  [[nodiscard]] bridge::ObstacleBoard& board() noexcept override { return senses_.board(); }

  void attach(RouteDriver& driver) { driver_ = &driver; }
  void receive() { link_->receive(*this, senses_.fleet()); }
  [[nodiscard]] SensedRobot measure();

  /// Sends a command after the last check; none to a robot at standstill without a route, which
  /// other programs may drive. @return what this robot shares with the others.
  std::optional<SharedMotion> command(const Twist2& twist, bool drives);

  [[nodiscard]] RobotLink& link() const noexcept { return *link_; }
  [[nodiscard]] bridge::FleetBoard& fleet() noexcept { return senses_.fleet(); }

 private:
  [[nodiscard]] Twist2 checked(const Twist2& twist);

  bridge::RobotSenses senses_;
  std::uint32_t number_;
  std::optional<bridge::CommandGuard> guard_;
  std::unique_ptr<RobotLink> link_;
  RouteDriver* driver_ = nullptr;
  double time_ = 0.0;  // of this cycle [s]
  Twist2 sent_{};
  int zeros_left_ = 0;  // commands that are still sent after standstill
};

/// The robots of one process behind a middleware. They share their plans with each other.
class LinkedRobots : public RobotBases {
 public:
  LinkedRobots(const Settings& settings,
               const LinkOptions& options,
               std::vector<std::unique_ptr<RobotLink>> links,
               std::vector<std::string> names);

  void attach(std::size_t index, RouteDriver& driver) override { robots_[index]->attach(driver); }
  void receive() override;
  [[nodiscard]] double longest_wait() const noexcept override { return 0.01; }
  [[nodiscard]] SensedRobot measure(std::size_t index) override {
    return robots_[index]->measure();
  }
  void command(std::size_t index, const Twist2& twist, bool drives) override;
  void advance(double /*dt*/) override {}
  bool place(std::size_t index, const Pose2& pose) override;
  [[nodiscard]] bool ended() const noexcept override;
  [[nodiscard]] bool must_brake() const noexcept override { return true; }
  void leave(std::size_t index) override;

 private:
  std::vector<std::unique_ptr<LinkedRobot>> robots_;
  std::vector<std::string> names_;
  std::vector<std::optional<SharedMotion>> shared_;  // last ones
};

}  // namespace fairway::vda5050
