// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "driver/driving_area.hpp"
#include "driver/leg_path.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"
#include "protocol/vehicle/vehicle.hpp"

namespace fairway::vda5050 {

/// The result of a driver's cycle.
struct DrivenRoute {
  Twist2 command;
  DriveReport report;
  NavigationStatus status = NavigationStatus::NoPlan;
  LimitingFactor limit = LimitingFactor::None;
  const MpcSolution* solution = nullptr;  ///< predicted motion until the next cycle; may be null
};

/// Drives a robot along the route of a vehicle: inside the strips, past obstacles, around blocked
/// zones, without a stop at the nodes.
///
/// It gives the navigator the legs of the next metres as a path and an allowed area, and extends
/// both before the robot reaches their end.
class RouteDriver {
 public:
  /// @throws std::invalid_argument unless validate(settings) holds.
  RouteDriver(const Settings& settings, const BitGrid& map);

  /// The first leg that the map and the zones close; none if all can be driven.
  [[nodiscard]] std::optional<std::size_t> first_closed(const Route& route,
                                                        const std::vector<vda5050::Zone>& zones);

  /// Processes a scan, as MapNavigator::observe.
  bool observe(const LidarScan& scan, const Eigen::Vector2d& position) {
    return navigator_.observe(scan, position);
  }

  /// Notes that the base moves otherwise than by the last command.
  void set_twist(const Twist2& actual) noexcept { navigator_.reset(actual); }

  /// Notes what was really sent in the last cycle, where a later check has changed it.
  void replace_last(const Twist2& sent) noexcept { navigator_.replace_last(sent); }

  /// Brakes: one control cycle without a route.
  [[nodiscard]] Twist2 brake(const Measurements& measurements);

  /// Runs one control cycle towards the end of the vehicle's route.
  [[nodiscard]] DrivenRoute drive(const Vehicle& vehicle, const Measurements& measurements);

  /// Restarts after the robot was put to another place.
  void restart();

  [[nodiscard]] const MapNavigator& navigator() const noexcept { return navigator_; }
  /// The path from the robot on, as far as it is planned [m].
  [[nodiscard]] std::vector<Eigen::Vector2d> planned(const Eigen::Vector2d& robot) const;

 private:
  // The legs that the navigator knows.
  struct Window {
    std::uint64_t route = 0;
    std::size_t first = 0;  // index of its first leg in the route
    std::size_t count = 0;
    bool whole = false;                       // it reaches the end of the route
    bool cut = false;                         // it ends before a leg that would open a shortcut
    bool stop = false;                        // the robot stops at the end of its first leg
    std::optional<std::size_t> closed_leg{};  // in the route
    std::vector<Eigen::Vector2d> path{};
  };

  void open_window(const Vehicle& vehicle, const Measurements& measurements);
  // The map with zones; none if the zones are unsound or too many.
  [[nodiscard]] std::optional<BitGrid> map_with(Zones zones) const;
  std::optional<std::size_t> choose_free_lines(std::vector<RouteLeg>& legs,
                                               const Eigen::Vector2d& robot,
                                               const std::vector<vda5050::Zone>& zones);
  [[nodiscard]] Zones strips_around(const RouteLeg& leg, const Eigen::Vector2d& robot) const;
  [[nodiscard]] LegPath window_path(const std::vector<RouteLeg>& legs,
                                    const Eigen::Vector2d& robot);
  [[nodiscard]] bool needs_window(const Vehicle& vehicle, const Measurements& measurements) const;
  void follow(const Vehicle& vehicle, Window window, const std::vector<RouteLeg>& legs);
  [[nodiscard]] bool makes_progress(const Pose2& pose);
  void report_progress(const Vehicle& vehicle,
                       const Measurements& measurements,
                       DrivenRoute& driven);

  Settings settings_;  // as given
  BitGrid map_;
  Planner planner_;
  MapNavigator navigator_;
  std::optional<Window> window_;
  std::optional<RouteLeg> last_leg_;  // the one passed last
  std::uint64_t known_route_ = 0;
  std::size_t known_passed_ = 0;
  std::vector<RouteLeg> known_legs_;  // of the route, to remember the last leg
  bool driving_ = false;
  bool arrived_ = false;
  double window_time_ = -1e9;  // of the last window [s]
  double moved_time_ = -1e9;   // when the robot last made progress [s]
  Pose2 moved_pose_{};         // and where
  double closed_time_ = -1.0;  // since when it waits [s]
};

}  // namespace fairway::vda5050
