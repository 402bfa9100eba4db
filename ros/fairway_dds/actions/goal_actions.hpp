// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "bridge/drive_progress.hpp"
#include "fairway_dds/actions/action_server.hpp"

namespace fairway::dds {

/// The reasons why a goal of an action ended, which the two actions number differently.
enum class ActionFault : std::uint8_t {
  None,
  Unknown,
  NoTransform,
  InvalidPath,
  StartOutsideMap,
  GoalOutsideMap,
  StartBlocked,
  GoalBlocked,
  NoPath,
  NoProgress,
};

/// The error code of Nav2's jazzy for a reason. NavigateToPose has those of the servers that it
/// uses: ComputePathToPose and FollowPath.
[[nodiscard]] std::uint16_t navigation_code(ActionFault fault) noexcept;
[[nodiscard]] std::uint16_t following_code(ActionFault fault) noexcept;

/// Returns why a drive was given up. @param path  The status of its plan.
[[nodiscard]] ActionFault fault_of(PathStatus path) noexcept;

/// The actions NavigateToPose and FollowPath of one robot, of which one goal is active at a time.
class GoalActions {
 public:
  struct Callbacks {
    std::function<void(const geometry_msgs_msg_dds__PoseStamped_&)> navigate;
    std::function<void(const nav_msgs_msg_dds__Path_&)> follow;
    std::function<void()> cancel;  ///< brake to standstill, then call `end`
  };

  GoalActions(Participant& participant, Callbacks callbacks);

  /// Handles all requests of clients. @param now  [s]
  void serve(double now);

  /// Whether a goal is active.
  [[nodiscard]] bool active() const noexcept {
    return navigate_.active() != nullptr || follow_.active() != nullptr;
  }
  /// Whether a client has cancelled the active goal.
  [[nodiscard]] bool canceling() const noexcept;

  /// Publishes feedback for the active goal, if there is one.
  void give_feedback(const bridge::DriveProgress& progress,
                     const Pose2& pose,
                     const std::string& frame,
                     double now);

  void succeed(double now);
  void abort(ActionFault fault, const std::string& text, double now);
  void canceled(double now);

 private:
  void end(bridge::ActionStatus status, ActionFault fault, const std::string& text, double now);

  Callbacks callbacks_;
  ActionServer<NavigateToPose> navigate_;
  ActionServer<FollowPath> follow_;
  bool warned_ = false;  // of clients with another middleware
};

}  // namespace fairway::dds
