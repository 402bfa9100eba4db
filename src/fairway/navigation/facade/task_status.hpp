// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/navigation/facade/navigation_task.hpp"
#include "fairway/navigation/facade/progress_watch.hpp"
#include "fairway/navigation/navigation_step.hpp"

namespace fairway {

/// How a navigator stands to its task after a cycle.
struct TaskView {
  double time = 0.0;                  ///< of the cycle [s]
  bool plan_is_current = false;       ///< the plan was made for the present task
  bool leads_to_goal = false;         ///< the plan ends at the task's goal
  bool new_way = false;               ///< the cycle has begun to follow another plan
  std::optional<double> remaining{};  ///< length of the way to the goal, where it is known [m]
  double patience = 0.0;              ///< without progress until the task is dropped [s]; 0: never
};

/// A task and what its navigator makes of it: turns the status of a cycle, which is about the plan
/// that is followed, into one about the task.
class TaskStatus {
 public:
  void begin(NavigationTask task);
  void end() noexcept;

  [[nodiscard]] const std::optional<NavigationTask>& task() const noexcept { return task_; }

  /// Whether there is a task that can be carried out.
  [[nodiscard]] bool can_be_done() const noexcept { return task_ && task_->valid; }

  /// The step as the task sees it. After the patience the task is dropped (GaveUp): then the caller
  /// makes the robot brake.
  [[nodiscard]] NavigationStep judge(NavigationStep step, const TaskView& view);

 private:
  std::optional<NavigationTask> task_;
  ProgressWatch progress_;
  bool gave_up_ = false;
};

}  // namespace fairway
