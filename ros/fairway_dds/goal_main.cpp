// SPDX-License-Identifier: Apache-2.0
// Sends one goal like `ros2 topic pub` or `ros2 action send_goal`, on machines without ROS 2.
#include <cmath>
#include <cstdio>
#include <random>

#include <CLI/CLI.hpp>

#include "bridge/message_conversions.hpp"
#include "fairway_dds/actions/action_client.hpp"
#include "fairway_dds/navigation_node.hpp"
#include "fairway_dds/orderly_exit.hpp"

namespace {

using namespace fairway;

constexpr double kLongestWait = 10.0;  // [s] until a receiver is found, or answers

// Waits until `done`, at most kLongestWait or until SIGINT.
template <typename Done>
bool wait_for(dds::Participant& participant, Done&& done) {
  const double begin = dds::wall_time();
  while (!done()) {
    if (dds::wall_time() - begin > kLongestWait || dds::exits_wanted > 0) return false;
    participant.wait(0.02);
  }
  return true;
}

int publish(dds::Participant& participant, const geometry_msgs_msg_dds__PoseStamped_& goal) {
  dds::Writer<geometry_msgs_msg_dds__PoseStamped_> writer(participant, "goal_pose", {});
  if (!wait_for(participant, [&] { return writer.is_read(); })) {
    std::fprintf(stderr, "fairway: %s has no reader\n",
                 participant.topic_name("goal_pose").c_str());
    return 1;
  }
  writer.send(goal);
  // Ends only after the reader has received the goal.
  dds_wait_for_acks(writer.get(), 2'000'000'000);
  return 0;
}

bridge::GoalId random_id() {
  std::random_device random;
  bridge::GoalId id{};
  for (std::uint8_t& byte : id)
    byte = static_cast<std::uint8_t>(random() & 0xFFU);
  return id;
}

void print_feedback(const dds::NavigateToPose::Feedback& feedback) {
  std::printf("feedback: %.2f m left\n", static_cast<double>(feedback.distance_remaining));
}
void print_feedback(const dds::FollowPath::Feedback& feedback) {
  std::printf("feedback: %.2f m left\n", static_cast<double>(feedback.distance_to_goal));
}

// Sends a goal of an action and waits for its result; SIGINT cancels it.
template <typename Action>
int act(dds::Participant& participant, const typename Action::Goal& goal) {
  dds::ActionClient<Action> client(participant);
  if (!wait_for(participant, [&] { return client.is_served(); })) {
    std::fprintf(stderr, "fairway: the action %s has no server\n", Action::kName);
    return 1;
  }
  const bridge::GoalId id = random_id();
  std::optional<bool> accepted;
  std::optional<bridge::ActionStatus> status;
  int cycles = 0;
  struct Callbacks {
    std::function<void(std::int64_t, const typename Action::SendGoalResponse&)> on_goal;
    std::function<void(std::int64_t, const action_msgs_srv_dds__CancelGoal_Response_&)> on_cancel;
    std::function<void(std::int64_t, const typename Action::GetResultResponse&)> on_result;
    std::function<void(const bridge::GoalId&, const typename Action::Feedback&)> on_feedback;
    std::function<void(const bridge::GoalId&, bridge::ActionStatus)> on_status;
  } callbacks{.on_goal = [&](std::int64_t, const auto& response) { accepted = response.accepted; },
              .on_cancel = [](std::int64_t, const auto&) {},
              .on_result =
                  [&](std::int64_t, const auto& response) {
                    status = static_cast<bridge::ActionStatus>(response.status);
                    std::printf("result: status %d, error code %d%s%s\n", response.status,
                                response.result.error_code, *response.result.error_msg ? ": " : "",
                                response.result.error_msg);
                  },
              .on_feedback =
                  [&](const bridge::GoalId& of, const auto& feedback) {
                    if (of == id && cycles++ % 10 == 0) print_feedback(feedback);
                  },
              .on_status = [](const bridge::GoalId&, bridge::ActionStatus) {}};
  client.send(id, goal);
  const bool answered = wait_for(participant, [&] {
    client.receive(callbacks);
    return accepted.has_value();
  });
  if (!answered || !*accepted) {
    std::fprintf(
        stderr, answered ? "fairway: the goal was rejected\n" : "fairway: no answer to the goal\n");
    return 1;
  }
  std::printf("goal accepted\n");
  client.request_result(id);
  for (bool canceled = false; !status && dds::exits_wanted < 2;) {
    participant.wait(0.05);
    client.receive(callbacks);
    if (dds::exits_wanted > 0 && !std::exchange(canceled, true)) client.cancel(id);
    std::fflush(stdout);
  }
  return status == bridge::ActionStatus::Succeeded ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Sends a goal to a robot over DDS");
  std::vector<double> goal;
  std::vector<double> path;
  std::uint32_t domain = 0;
  std::string space;
  std::string frame = "map";
  bool action = false;
  auto* const pose = app.add_option("--goal", goal, "x,y or x,y,heading [m, rad]");
  pose->delimiter(',')->expected(2, 3);
  app.add_option("--path", path, "x,y,x,y,...: a path for the action FollowPath [m]")
      ->delimiter(',')
      ->expected(2, 100000)
      ->excludes(pose);
  app.add_flag("--action", action,
               "Send --goal as the action NavigateToPose, and wait for its result");
  app.add_option("--domain", domain, "ROS_DOMAIN_ID")->check(CLI::Range(0, 232));
  app.add_option("--namespace", space, "Namespace of the robot's topics");
  app.add_option("--frame", frame);
  try {
    app.parse(argc, argv);
    if (goal.empty() == path.empty()) throw CLI::RequiredError("--goal or --path");
    if (path.size() % 2 != 0) throw CLI::ValidationError("--path", "expected x,y,x,y,...");
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "fairway: %s\n", error.what());
    return 2;
  }
  dds::take_over_exit();
  dds::Participant participant(domain, space);
  std::string none;
  std::vector<geometry_msgs_msg_dds__PoseStamped_> poses;
  const auto add = [&](double x, double y, double heading) {
    poses.emplace_back();
    poses.back().header = dds::header(frame, dds::wall_time());
    bridge::set_pose({.position = {x, y}, .heading = heading}, poses.back().pose);
  };
  if (!goal.empty()) {
    add(goal[0], goal[1], goal.size() > 2 ? goal[2] : 0.0);
    if (!action) return publish(participant, poses[0]);
    return act<dds::NavigateToPose>(participant, {.pose = poses[0], .behavior_tree = none.data()});
  }
  for (std::size_t i = 0; i + 1 < path.size(); i += 2) {
    const std::size_t last = std::min(i, path.size() - 4);  // the direction of the last line
    const double heading =
        path.size() < 4 ? 0.0
                        : std::atan2(path[last + 3] - path[last + 1], path[last + 2] - path[last]);
    add(path[i], path[i + 1], heading);
  }
  dds::FollowPath::Goal follow{};
  follow.path.header = poses[0].header;
  dds::point_to(poses, follow.path.poses);
  follow.controller_id = follow.goal_checker_id = follow.progress_checker_id = none.data();
  return act<dds::FollowPath>(participant, follow);
}
