// SPDX-License-Identifier: Apache-2.0
#include "fairway_dds/navigation_node.hpp"

#include <chrono>
#include <cstdio>
#include <utility>

#include "bridge/message_conversions.hpp"
#include "fairway_dds/dds_conversions.hpp"

namespace fairway::dds {

double wall_time() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

NavigationNode::NavigationNode(const Settings& settings, const NodeOptions& options)
    : options_(options),
      pilot_(settings, options.pilot),
      clock_(options.pilot.use_scan),
      participant_(options.domain, options.space),
      sensors_(participant_,
               {.map_frame = options.map_frame,
                .base_frame = options.base_frame,
                .use_map = options.pilot.use_map,
                .use_scan = options.pilot.use_scan}),
      fleet_(participant_, options.name),
      actions_(participant_,
               {.navigate = [this](const auto& goal) { take_goal(goal, true); },
                .follow = [this](const auto& path) { take_path(path); },
                .cancel = [this] { cancel_goal(); }}) {
  if (options_.sim_time) {
    simulated_clock_.emplace(participant_, "/clock", Quality{.reliable = false, .depth = 1});
  }
  if (options_.stamped) {
    stamped_command_.emplace(participant_, "cmd_vel", Quality{});
  } else {
    command_.emplace(participant_, "cmd_vel", Quality{});
  }
  if (options_.pilot.body && is_steered(options_.pilot.body->base))
    steering_.emplace(participant_, "steering_angle", Quality{});
}

double NavigationNode::now() const { return options_.sim_time ? simulated_time_ : wall_time(); }

void NavigationNode::tick() {
  constexpr double kLongestWait = 0.005;  // [s]
  participant_.wait(kLongestWait);
  receive();
  const double time = now();
  if (options_.sim_time && time == 0.0) return;  // no message of the clock yet
  if (clock_.due(time, pilot_.settings().navigation.control_period,
                 std::exchange(scan_came_, false))) {
    run_cycle(time);
  }
}

void NavigationNode::receive() {
  if (simulated_clock_) {
    simulated_clock_->take([this](const rosgraph_msgs_msg_dds__Clock_& message) {
      simulated_time_ = seconds_of(message.clock);
    });
  }
  map_.take([this](const nav_msgs_msg_dds__OccupancyGrid_& message) {
    const Expected<OccupancyGrid> grid = to_grid(message);
    if (grid) {
      pilot_.set_map(*grid);
    } else {
      std::fprintf(stderr, "fairway: %s\n", grid.error().message.c_str());
    }
  });
  if (sensors_.take(pilot_)) scan_came_ = true;
  fleet_.take(pilot_.fleet(), sensors_, now());
  cancel_.take([this](const auto& /*message*/) {
    cancel_goal();
    actions_.abort(ActionFault::Unknown, "cancelled by the topic cancel_goal", now());
  });
  goal_.take([this](const auto& message) { take_goal(message, false); });
  actions_.serve(now());
  place_goal();
}

void NavigationNode::run_cycle(double now) {
  clock_.begin(now);
  follow_piece();
  const bridge::PilotStep step = pilot_.cycle(now);
  if (step.send) send(step);
  if (!ends_piece(step, now)) report_goal(step, now);
  if (step.new_plan) {
    const Plan& plan = pilot_.navigator()->plan();
    plan_.send(PathMessage(plan.path, world_frame(), now).get());
    corridor_.send(CorridorMessage(plan.corridor, world_frame(), now).get());
  }
  tell_fleet(now, false);
}

void NavigationNode::send(const bridge::PilotStep& step) {
  geometry_msgs_msg_dds__Twist_ message{};
  bridge::set_planar_twist(
      {.linear = step.command.linear, .lateral = step.lateral, .angular = step.command.angular},
      message);
  if (steering_ && step.send) steering_->send(std_msgs_msg_dds__Float64_{.data = step.steering});
  if (command_) {
    command_->send(message);
    return;
  }
  const geometry_msgs_msg_dds__TwistStamped_ stamped{.header = header(options_.base_frame, now()),
                                                     .twist = message};
  stamped_command_->send(stamped);
}

void NavigationNode::tell_status(const std::string& text) {
  told_ = text;
  const std_msgs_msg_dds__String_ message{.data = told_.data()};
  status_.send(message);
  status_marker_.send(StatusMarkerMessage(text, options_.base_frame, now()).get());
}

void NavigationNode::tell_fleet(double now, bool leaving) {
  if (options_.name.empty()) return;
  if (const auto motion = pilot_.share(now)) {
    fleet_.send(*motion, world_frame(), leaving);
  }
}

void NavigationNode::stop(bool (*urgent)()) {
  constexpr double kLongest = 3.0;  // [s]
  const double begin = wall_time();
  cancel_goal();
  actions_.abort(ActionFault::Unknown, "the node shuts down", now());
  while (pilot_.state() != bridge::PilotState::Idle && !urgent() && wall_time() - begin < kLongest)
    tick();
  send({});
  tell_fleet(now(), true);
  participant_.wait(0.05);  // lets the protocol's threads send it
}

}  // namespace fairway::dds
