// SPDX-License-Identifier: Apache-2.0
#include "fairway_ros/node_outputs.hpp"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/Twist.h>
#include <std_msgs/Float64.h>

#include "bridge/message_conversions.hpp"
#include "bridge/plan_markers.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/navigation/explanation/status_guide.hpp"
#include "fairway_ros/message_conversions.hpp"

namespace fairway::ros1 {

namespace {

using diagnostic_msgs::DiagnosticStatus;

// Normal driving and stopping is OK. A state that deserves attention is a warning; one that needs
// an operator is an error.
std::int8_t level_of(NavigationStatus status) noexcept {
  switch (status) {
    case NavigationStatus::Ok:
    case NavigationStatus::Degraded:
    case NavigationStatus::GoalReached:
    case NavigationStatus::Planning:
    case NavigationStatus::Holding:
      return DiagnosticStatus::OK;
    case NavigationStatus::Stopping:
    case NavigationStatus::Blocked:
    case NavigationStatus::Recovering:
    case NavigationStatus::NoPlan:
    case NavigationStatus::GaveUp:
      return DiagnosticStatus::WARN;
    case NavigationStatus::Stale:
    case NavigationStatus::BadInput:
    case NavigationStatus::Infeasible:
      return DiagnosticStatus::ERROR;
  }
  return DiagnosticStatus::ERROR;
}

}  // namespace

NodeOutputs::NodeOutputs(ros::NodeHandle node, ros::NodeHandle own, bool steered)
    : command_(node.advertise<geometry_msgs::Twist>("cmd_vel", 1)),
      plan_(own.advertise<nav_msgs::Path>("plan", 1, true)),
      corridor_(own.advertise<visualization_msgs::MarkerArray>("corridor", 1, true)),
      prediction_(own.advertise<nav_msgs::Path>("prediction", 1)),
      obstacles_(own.advertise<sensor_msgs::PointCloud2>("tracked_obstacles", 1)),
      obstacle_markers_(own.advertise<visualization_msgs::MarkerArray>("obstacle_markers", 1)),
      footprint_(own.advertise<geometry_msgs::PolygonStamped>("footprint", 1)),
      status_(own.advertise<DiagnosticStatus>("status", 10, true)),
      status_marker_(own.advertise<visualization_msgs::MarkerArray>("status_marker", 1)),
      diagnostics_(node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1)) {
  if (steered) steering_ = node.advertise<std_msgs::Float64>("steering_angle", 1);
  last_status_.name = own.getNamespace().substr(1);
  last_status_.hardware_id = last_status_.name;
  last_status_.message = "no goal";
}

void NodeOutputs::send(const bridge::PilotStep& step) {
  geometry_msgs::Twist message;
  bridge::set_planar_twist(
      {.linear = step.command.linear, .lateral = step.lateral, .angular = step.command.angular},
      message);
  command_.publish(message);
  if (!steering_ || !step.send) return;
  std_msgs::Float64 angle;
  angle.data = step.steering;
  steering_.publish(angle);
}

void NodeOutputs::show(const bridge::Pilot& pilot,
                       const bridge::PilotStep& step,
                       const std::string& frame,
                       const std::optional<ScanTimes>& scan,
                       double seconds) {
  publish_status(pilot, step, scan, seconds);
  const double time = pilot.odometry().empty() ? 0.0 : pilot.odometry().time();
  const std_msgs::Header now = header(frame, time);
  if (const auto pose = pilot.pose(); pose && footprint_.getNumSubscribers() > 0) {
    footprint_.publish(to_message(pilot.settings().robot, *pose, now));
  }
  if (const auto pose = pilot.pose(); pose && status_marker_.getNumSubscribers() > 0) {
    std::string text = last_status_.message;
    if (step.limit != LimitingFactor::None) text += std::string(": ") + to_text(step.limit);
    visualization_msgs::MarkerArray markers;
    bridge::add_text(text, now, markers);
    markers.markers.back().pose.position.x = pose->position.x();
    markers.markers.back().pose.position.y = pose->position.y();
    status_marker_.publish(markers);
  }
  if (pilot.navigator() == nullptr) return;
  const Plan& plan = pilot.navigator()->plan();
  if (step.new_plan) plan_.publish(to_message(plan.path, now));
  if (step.new_plan || step.rectangle != shown_rectangle_) {
    corridor_.publish(corridor_markers(plan.corridor, step.rectangle, now));
    shown_rectangle_ = step.rectangle;
  }
  if (step.plan != nullptr && prediction_.getNumSubscribers() > 0) {
    prediction_.publish(to_message(*step.plan, pilot.settings().mpc.step_length, now));
  }
  if (obstacles_.getNumSubscribers() > 0) {
    obstacles_.publish(to_cloud(pilot.navigator()->tracked(), now));
  }
  if (obstacle_markers_.getNumSubscribers() > 0) {
    obstacle_markers_.publish(obstacle_markers(pilot.navigator()->tracked(), now));
  }
}

void NodeOutputs::publish_status(const bridge::Pilot& pilot,
                                 const bridge::PilotStep& step,
                                 const std::optional<ScanTimes>& scan,
                                 double seconds) {
  DiagnosticStatus& status = last_status_;
  status.values.clear();
  const auto add = [&status](const char* key, const std::string& value) {
    status.values.emplace_back();
    status.values.back().key = key;
    status.values.back().value = value;
  };
  if (!step.send) {
    status.level = DiagnosticStatus::OK;
    status.message = "no goal";
    return;  // the diagnostics repeat it once a second; between goals there is no new status
  }
  status.level = level_of(step.status);
  status.message = to_text(step.status);
  add("limit", to_text(step.limit));
  // The texts of `fairway statuses`: the limit is more specific where there is one.
  const StatusGuide guide =
      step.limit == LimitingFactor::None ? guide_of(step.status) : guide_of(step.limit);
  add("meaning", guide.meaning);
  if (guide.remedy[0] != '\0') add("remedy", guide.remedy);
  add("cycle_seconds", io::number_text(seconds));
  if (scan) {
    const double sent = ros::Time::now().toSec();
    add("scan_to_command_seconds", io::number_text(sent - scan->taken));
    add("received_to_command_seconds", io::number_text(sent - scan->received));
  }
  if (pilot.navigator() != nullptr) {
    const Plan& plan = pilot.navigator()->plan();
    add("rectangle", std::to_string(step.rectangle + 1) + " of " +
                         std::to_string(plan.corridor.rectangles.size()));
    if (!plan.usable() && pilot.has_planned()) add("plan", pilot.navigator()->why_no_plan());
    if (!step.explanation.empty()) add("explanation", step.explanation);
  }
  status_.publish(status);
}

void NodeOutputs::publish_diagnostics() {
  diagnostic_msgs::DiagnosticArray message;
  message.header.stamp = ros::Time::now();
  message.status.push_back(last_status_);
  diagnostics_.publish(message);
}

}  // namespace fairway::ros1
