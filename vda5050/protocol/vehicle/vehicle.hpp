// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/messages/factsheet.hpp"
#include "protocol/messages/vehicle_state.hpp"
#include "protocol/orders/action_queue.hpp"
#include "protocol/orders/active_order.hpp"
#include "protocol/orders/node_passing.hpp"
#include "protocol/orders/refusal.hpp"
#include "protocol/vehicle/leave_requests.hpp"
#include "protocol/vehicle/zone_store.hpp"

namespace fairway::vda5050 {

/// A message for the broker.
struct OutgoingMessage {
  Topic topic = Topic::State;
  std::string payload;
  int qos = 0;
  bool retained = false;
};

enum class ConnectionState : std::uint8_t { Online, Offline, Broken };

/// What the driver reports in a cycle about the route that it was given.
struct DriveReport {
  std::uint64_t route = 0;  ///< revision of the route
  bool arrived = false;     ///< stopped at its end
  bool at_node = false;     ///< stopped at the end of its present leg, before the route's end
  /// Index of the leg that is closed by an obstacle, while the vehicle waits for it.
  std::optional<std::size_t> closed_leg{};
  bool gave_up = false;  ///< waited for too long
};

/// What the vehicle asks of the driver before it takes an order: the index of the first leg that
/// cannot be driven; none if all can be.
using RouteCheck =
    std::function<std::optional<std::size_t>(const Route& route, const std::vector<Zone>& zones)>;

/// Puts the vehicle's localisation at a pose. @return whether it is possible.
using PoseSetter = std::function<bool(const Pose2& pose)>;

/// A vehicle as the standard describes it: takes messages and measurements, and gives messages and
/// the route to drive. It knows neither a broker nor a clock: every call gets the time [s since
/// 1970].
class Vehicle {
 public:
  Vehicle(VehicleIdentity identity, VehicleDescription description, std::string map_id);

  void set_route_check(RouteCheck check) { route_check_ = std::move(check); }
  void set_pose_setter(PoseSetter setter) { pose_setter_ = std::move(setter); }

  /// Handles a message of the fleet control.
  void receive(Topic topic, std::string_view payload, double now);

  /// Notes the measurements of a control cycle and what the driver reports.
  void update(const VehicleMotion& motion, const DriveReport& report, double now);

  /// Announces the vehicle after the broker was reached: connection, factsheet and state.
  void announce(double now);

  /// Changes the operating mode. Modes that take no orders clear the order.
  void set_mode(OperatingMode mode);

  /// Returns the messages that are due.
  [[nodiscard]] std::vector<OutgoingMessage> take_messages(double now);
  /// Whether a change waits for the least interval between states.
  [[nodiscard]] bool owes_state() const noexcept { return changed_; }

  /// Makes a message of the topic `connection`.
  [[nodiscard]] OutgoingMessage connection_message(ConnectionState state, double now);

  /// The legs to drive since the last revision of the route, and how many of them are passed.
  [[nodiscard]] const Route& route() const noexcept { return route_; }
  [[nodiscard]] std::uint64_t route_revision() const noexcept { return route_revision_; }
  [[nodiscard]] std::size_t legs_passed() const noexcept { return legs_passed_; }

  /// Returns whether the vehicle may drive along the route now; otherwise it brakes.
  [[nodiscard]] bool may_drive() const noexcept;

  /// The enabled zones that hold: not those that the vehicle has leave to enter.
  [[nodiscard]] const std::vector<Zone>& zones() const noexcept { return in_force_; }

  [[nodiscard]] const VehicleIdentity& identity() const noexcept { return identity_; }
  [[nodiscard]] const ActiveOrder& order() const noexcept { return order_; }
  [[nodiscard]] bool idle() const noexcept;
  [[nodiscard]] bool paused() const noexcept { return paused_; }
  [[nodiscard]] VehicleState state() const;

 private:
  struct InstantEntry {
    ActionState state;
    bool cancels = false;  // a cancelOrder that waits for standstill
    bool pauses = false;   // a startPause that waits for standstill
  };

  // receiving.cpp
  void refuse_message(Topic topic, const std::string& text, const nlohmann::json& message);
  // order_reception.cpp
  void receive_order(const nlohmann::json& message, double now);
  [[nodiscard]] std::optional<VehicleError> order_problem(const Order& order) const;
  [[nodiscard]] std::optional<VehicleError> new_order_problem(const Order& order) const;
  [[nodiscard]] std::optional<VehicleError> update_problem(const Order& order) const;
  [[nodiscard]] std::optional<VehicleError> place_problem(const Order& order) const;
  [[nodiscard]] std::optional<VehicleError> route_problem(const Order& order) const;
  [[nodiscard]] VehicleError order_error(Fault fault, std::string text, const Order& order) const;
  void refuse_order(VehicleError error);
  void list_actions(const Order& order, std::size_t first_node);
  // instant_reception.cpp
  void receive_instant_actions(const nlohmann::json& message, double now);
  void start_instant(const Action& action, double now);
  void cancel_order(const Action& action, InstantEntry& entry);
  void set_position(const Action& action, InstantEntry& entry);
  void change_zones(const Action& action, InstantEntry& entry);
  void fail_instant(InstantEntry& entry, Fault fault, std::string text);
  // zones and leave
  void receive_zone_set(const nlohmann::json& message);
  void receive_responses(const nlohmann::json& message);
  // vehicle_motion.cpp
  void pass_nodes(const DriveReport& report, const Eigen::Vector2d& before);
  void pass_node();
  void enter_edge();
  void finish_waiting_actions();
  void judge_place();
  void judge_report(const DriveReport& report, double now);
  void rebuild_route();
  [[nodiscard]] RouteLeg leg_in_force(std::size_t index) const;
  [[nodiscard]] bool lost_leave() const;
  void note_lost_leave();
  [[nodiscard]] bool is_outside() const;
  [[nodiscard]] double base_left() const;
  // vehicle_zones.cpp
  [[nodiscard]] bool is_inside(const Zone& zone) const;
  [[nodiscard]] bool leads_through(const Zone& zone) const;
  [[nodiscard]] std::vector<Eigen::Vector2d> line_ahead() const;
  [[nodiscard]] bool is_closed(const Zone& zone) const;
  [[nodiscard]] std::vector<Zone> zones_with_leave() const;
  void use_zones(std::vector<Zone> zones);
  void refresh_zones();
  void find_zones_ahead();
  void update_zone_leave();
  // writing
  void set_condition(Fault fault, bool holds, std::string text, std::vector<Reference> references);
  [[nodiscard]] std::string message_text(Topic topic, nlohmann::json body, double now);

  VehicleIdentity identity_;
  VehicleDescription description_;
  std::string map_id_;
  double body_;  // distance from the reference point to the nearest side of the body [m]
  RouteCheck route_check_;
  PoseSetter pose_setter_;

  ActiveOrder order_;
  ActionQueue queue_;
  NodePassing passing_;
  std::vector<InstantEntry> instant_;
  ZoneStore zone_sets_;
  std::vector<Zone> zones_;                // of the enabled set
  std::vector<Zone> in_force_;             // of these
  LeaveRequests<std::uint32_t> leave_;     // for corridors, by the edge's sequence number
  LeaveRequests<std::string> zone_leave_;  // by the zone's id
  std::set<std::string> zones_ahead_;      // that need leave and lie on later edges of the base
  std::uint64_t zone_route_ = ~std::uint64_t{};  // for which they were found
  std::size_t zone_legs_ = 0;
  bool zone_holds_ = false;      // inside a zone without leave
  bool waits_for_zone_ = false;  // that lies on the base
  OperatingMode mode_ = OperatingMode::Automatic;
  bool paused_ = false;
  bool cancelling_ = false;
  bool outside_ = false;
  bool returning_ = false;  // the leave ended beside the line
  bool in_blocked_zone_ = false;
  bool unreachable_ = false;  // until another order or update

  Route route_;
  std::uint64_t route_revision_ = 0;
  std::size_t legs_passed_ = 0;
  std::optional<RouteLeg> last_leg_;  // the one that was passed last

  VehicleMotion motion_;
  bool has_motion_ = false;
  double distance_ = 0.0;  // since the last node [m]
  double closed_since_ = -1.0;

  std::vector<VehicleError> order_errors_;                  // until an order is accepted
  std::vector<VehicleError> instant_errors_;                // until an instant action is accepted
  std::vector<VehicleError> zone_errors_;                   // until a zone set is accepted
  std::vector<std::pair<Fault, VehicleError>> conditions_;  // while they hold

  std::array<std::uint32_t, 8> header_ids_{};  // per topic
  bool changed_ = true;
  bool wants_state_ = false;
  bool wants_factsheet_ = false;
  bool announces_ = false;
  bool new_base_request_ = false;
  double last_state_ = -1.0e18;
  double last_visualization_ = -1.0e18;
};

}  // namespace fairway::vda5050
