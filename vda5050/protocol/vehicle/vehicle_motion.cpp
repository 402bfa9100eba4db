// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "protocol/vehicle/vehicle.hpp"

namespace fairway::vda5050 {

namespace {

constexpr double kArrivalSlack = 0.05;  // [m]
constexpr double kStripSlack = 0.03;    // beyond a strip until it counts as left [m]

}  // namespace

bool Vehicle::idle() const noexcept { return order_.passed_all() && queue_.all_done(); }

bool Vehicle::may_drive() const noexcept {
  return has_motion_ && motion_.localized && !paused_ && !cancelling_ && !outside_ &&
         !in_blocked_zone_ && !zone_holds_ && !unreachable_ && legs_passed_ < route_.legs.size() &&
         !queue_.forbids_driving();
}

// Whether the leave for the present corridor ended while the vehicle was beside its line.
bool Vehicle::lost_leave() const {
  if (order_.legs.empty() || !has_motion_) return false;
  const std::optional<Corridor>& corridor = order_.edges.front().corridor;
  if (!corridor || !corridor->release_required) return false;
  if (!leave_.lost(order_.edges.front().sequence)) return false;
  return nearest_on(order_.legs.front().line, motion_.pose.position).distance > kLineTolerance;
}

// The leg with the strip that may be used now.
RouteLeg Vehicle::leg_in_force(std::size_t index) const {
  RouteLeg leg = order_.legs[index];
  const std::optional<Corridor>& corridor = order_.edges[index].corridor;
  if (!corridor || !corridor->release_required || leave_.granted(leg.edge_sequence)) return leg;
  leg.returns = index == 0 && returning_ && corridor->release_loss == ReleaseLoss::Return;
  if (leg.returns) return leg;
  leg.strip = Strip{.left = std::min(kLineTolerance, corridor->left),
                    .right = std::min(kLineTolerance, corridor->right)};
  return leg;
}

// The route ends where the vehicle must stop: at the end of the base, at a node with an action that
// forbids driving, or at a node that cannot be passed on the way.
void Vehicle::rebuild_route() {
  Route route;
  if (!cancelling_) {
    const std::size_t released = std::min(order_.released_nodes(), order_.legs.size());
    for (std::size_t i = 0; i < released; ++i) {
      route.legs.push_back(leg_in_force(i));
      const bool last = i + 1 == released;
      if (last || queue_.will_stop_at(order_.nodes[i].sequence) ||
          needs_stop(order_.legs[i], order_.legs[i + 1])) {
        route.heading = order_.nodes[i].place.theta;
        break;
      }
    }
  }
  route_ = std::move(route);
  legs_passed_ = 0;
  ++route_revision_;
}

void Vehicle::pass_node() {
  changed_ = true;
  distance_ = 0.0;
  const bool had_edge = !order_.edges.empty();
  const std::uint32_t edge = had_edge ? order_.edges.front().sequence : 0;
  if (had_edge) {
    last_leg_ = order_.legs.front();
    queue_.leave(edge);
    leave_.finish(edge);
  }
  order_.pass_node();
  queue_.enter(order_.last_node_sequence);
  passing_.reset();
  ++legs_passed_;
}

// The actions of an edge start when the vehicle drives on from the node before it.
void Vehicle::enter_edge() {
  if (order_.edges.empty() || !order_.edges.front().released || queue_.forbids_driving() ||
      cancelling_) {
    return;
  }
  queue_.enter(order_.edges.front().sequence);
  constexpr std::size_t kAhead = 2;
  for (std::size_t i = 0; i < std::min(order_.edges.size(), kAhead); ++i) {
    const OrderEdge& edge = order_.edges[i];
    if (!edge.released || !edge.corridor || !edge.corridor->release_required) continue;
    const std::string prefix = order_.id + "/" + std::to_string(edge.sequence);
    if (leave_.request(prefix, edge.sequence, edge.id)) changed_ = true;
  }
}

void Vehicle::pass_nodes(const DriveReport& report, const Eigen::Vector2d& before) {
  if (cancelling_) return;
  bool stopped = report.at_node && report.route == route_revision_;
  while (!order_.nodes.empty() && order_.nodes.front().released && !order_.legs.empty()) {
    if (legs_passed_ >= route_.legs.size()) return rebuild_route();
    const bool stops_there = legs_passed_ + 1 == route_.legs.size();
    const RouteLeg leg = leg_in_force(0);
    if (stops_there) {
      const bool arrived = report.arrived && report.route == route_revision_;
      if (!arrived || !is_at(order_.nodes.front().place, motion_.pose, kArrivalSlack)) return;
    } else {
      const RouteLeg next = leg_in_force(1);
      const bool there = stopped && is_at(order_.nodes.front().place, motion_.pose, kArrivalSlack);
      if (!there && !passing_.passes(leg, &next, before, motion_.pose.position, body_)) return;
      stopped = false;
    }
    pass_node();
    if (stops_there) rebuild_route();
  }
}

bool Vehicle::is_outside() const {
  if (order_.legs.empty() || !order_.edges.front().released || cancelling_) return false;
  const Eigen::Vector2d& here = motion_.pose.position;
  const RouteLeg& leg = order_.legs.front();
  if (outside_by(leg, here, body_) <= kStripSlack) return false;
  if (ellipse_distance(leg.start, here) <= 1.0) return false;
  const bool near_end = ellipse_distance(leg.end, here) <= 1.0;
  if (order_.legs.size() > 1 && outside_by(order_.legs[1], here, body_) <= kStripSlack && near_end)
    return false;
  if (!last_leg_) return true;
  const double reach = reach_of(used_deviation(leg.start.deviation)) + kOwnDeviation;
  return (here - leg.start.position).norm() > reach ||
         outside_by(*last_leg_, here, body_) > kStripSlack;
}

void Vehicle::judge_place() {
  set_condition(Fault::NotLocalized, !motion_.localized, "the position is not known", {});
  const bool outside = motion_.localized && is_outside();
  if (outside != outside_) {
    outside_ = outside;
    const std::string edge = outside ? order_.edges.front().id : std::string();
    set_condition(Fault::OutsideCorridor, outside,
                  "the vehicle is outside the allowed strip of edge \"" + edge + "\"",
                  {{.key = "edgeId", .value = edge}, {.key = "orderId", .value = order_.id}});
  }
  const Zone* blocked = nullptr;
  for (const Zone& zone : zones_) {
    if (zone.type == ZoneType::Blocked && distance_to(zone.vertices, motion_.pose.position) < body_)
      blocked = &zone;
  }
  const bool inside = motion_.localized && blocked != nullptr;
  if (inside == in_blocked_zone_) return;
  in_blocked_zone_ = inside;
  const std::string id = inside ? blocked->id : std::string();
  set_condition(Fault::BlockedZone, inside, "the vehicle is in the blocked zone \"" + id + "\"",
                {{.key = "zoneId", .value = id}});
}

void Vehicle::judge_report(const DriveReport& report, double now) {
  const bool current = report.route == route_revision_ && !order_.legs.empty() && !unreachable_;
  const std::size_t passed = std::min(report.closed_leg.value_or(0), route_.legs.size());
  const std::size_t ahead = passed >= legs_passed_ ? passed - legs_passed_ : 0;
  const bool closed = current && report.closed_leg && ahead < order_.legs.size() && may_drive();
  if (!closed) {
    if (closed_since_ >= 0.0) set_condition(Fault::CorridorClosed, false, {}, {});
    closed_since_ = -1.0;
    return;
  }
  const OrderEdge& edge = order_.edges[ahead];
  // A vehicle that waits for leave, or whose leave has ended, is not stopped by an obstacle.
  const bool waits_for_corridor =
      edge.corridor && edge.corridor->release_required && !leave_.granted(edge.sequence);
  if (waits_for_corridor || waits_for_zone_) {
    closed_since_ = -1.0;
    return;
  }
  if (closed_since_ < 0.0) closed_since_ = now;
  const std::vector<Reference> references{{.key = "nodeId", .value = order_.nodes[ahead].id},
                                          {.key = "edgeId", .value = edge.id},
                                          {.key = "orderId", .value = order_.id}};
  if (report.gave_up) {
    unreachable_ = true;
    set_condition(Fault::CorridorClosed, false, {}, {});
    set_condition(Fault::NodeUnreachable, true,
                  "obstacles close edge \"" + edge.id + "\"; cancel the order or send another one",
                  references);
    return;
  }
  constexpr double kSilence = 3.0;  // until the wait is reported [s]
  if (now - closed_since_ < kSilence) return;
  set_condition(Fault::CorridorClosed, true,
                "obstacles close the allowed strip of edge \"" + edge.id + "\"; the vehicle waits",
                references);
}

// A vehicle beside its line whose leave has ended stops or returns, as the corridor says.
void Vehicle::note_lost_leave() {
  const bool lost = lost_leave();
  if (lost == returning_) return;
  returning_ = lost;
  const std::string edge = lost ? order_.edges.front().id : std::string();
  set_condition(Fault::ReleaseLost, lost,
                "the leave for the corridor of edge \"" + edge + "\" has ended",
                {{.key = "edgeId", .value = edge}});
  rebuild_route();
}

double Vehicle::base_left() const {
  if (order_.legs.empty()) return 0.0;
  double left = 0.0;
  const std::size_t released = std::min(order_.released_nodes(), order_.legs.size());
  for (std::size_t i = 0; i < released; ++i) {
    const RouteLeg& leg = order_.legs[i];
    left += length_of(leg.line);
    if (i == 0) left -= nearest_on(leg.line, motion_.pose.position).arc;
  }
  return left;
}

void Vehicle::update(const VehicleMotion& motion, const DriveReport& report, double now) {
  const Eigen::Vector2d before = has_motion_ ? motion_.pose.position : motion.pose.position;
  if (!has_motion_ || motion.driving != motion_.driving || motion.localized != motion_.localized)
    changed_ = true;
  motion_ = motion;
  has_motion_ = true;
  distance_ += (motion.pose.position - before).norm();
  pass_nodes(report, before);
  enter_edge();
  if (leave_.expire(now)) {
    changed_ = true;
    rebuild_route();
  }
  if (zone_leave_.expire(now)) changed_ = true;
  note_lost_leave();
  update_zone_leave();
  const bool held = queue_.forbids_driving();
  if (queue_.update(now)) changed_ = true;
  if (held && !queue_.forbids_driving()) enter_edge();
  finish_waiting_actions();
  judge_place();
  judge_report(report, now);
  const double speed = description_.robot.linear_max;
  constexpr double kAhead = 2.0;  // [s]
  const bool wants = !order_.nodes.empty() && !cancelling_ &&
                     base_left() < braking_distance(description_.robot) + kAhead * speed;
  if (wants != new_base_request_) changed_ = true;
  new_base_request_ = wants;
}

void Vehicle::set_mode(OperatingMode mode) {
  if (mode == mode_) return;
  mode_ = mode;
  changed_ = true;
  const bool keeps = mode == OperatingMode::Automatic || mode == OperatingMode::Semiautomatic ||
                     mode == OperatingMode::Intervened;
  std::erase_if(order_errors_, [&](const VehicleError& error) {
    return error.type == type_of(Fault::NotAvailable, identity_.version) && keeps;
  });
  if (keeps) return;
  queue_.cancel();
  order_.clear_ahead();
  order_.cancelled = true;
  leave_.clear();
  rebuild_route();
}

}  // namespace fairway::vda5050
