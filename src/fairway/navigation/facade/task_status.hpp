// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/navigation/facade/navigation_task.hpp"
#include "fairway/navigation/facade/progress_watch.hpp"
#include "fairway/navigation/navigation_step.hpp"

namespace fairway {

class Navigator;

/// The state of a navigator with respect to its task after a cycle.
struct TaskView {
  double time = 0.0;                  ///< time of the cycle [s]
  bool plan_is_current = false;       ///< whether the plan was made for the present task
  bool leads_to_goal = false;         ///< whether the plan ends at the task's goal
  bool new_path = false;              ///< whether the cycle started to follow another plan
  std::optional<double> remaining{};  ///< length of the path to the goal, if known [m]
  double turn = 0.0;                  ///< to the path, or to the goal's heading; unsigned [rad]
  double patience = 0.0;  ///< time without progress until the task is dropped [s]; 0: never
};

/// Returns how far the robot still has to turn, unsigned [rad]. At the goal this is the turn to its
/// heading, before that to the path. @pre a path is followed.
[[nodiscard]] double turn_left(const Navigator& navigator, const Pose2& pose) noexcept;

/// Holds a task, and converts the status of the plan being followed into the status of the task.
class TaskStatus {
 public:
  /// Starts a task, and drops the one before.
  void begin(NavigationTask task);
  /// Drops the task.
  void end() noexcept;

  [[nodiscard]] const std::optional<NavigationTask>& task() const noexcept { return task_; }

  /// Returns whether there is a valid task.
  [[nodiscard]] bool can_be_done() const noexcept { return task_ && task_->valid; }

  /// Converts a step. If there is no progress for `patience`, the task is dropped (GaveUp); the
  /// caller then makes the robot brake.
  [[nodiscard]] NavigationStep judge(NavigationStep step, const TaskView& view);

 private:
  std::optional<NavigationTask> task_;
  ProgressWatch progress_;
  bool gave_up_ = false;
};

}  // namespace fairway
