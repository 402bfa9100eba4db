// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <future>
#include <optional>

#include "fairway/navigation/settings.hpp"
#include "fairway/planning/planner.hpp"

namespace fairway::bridge {

/// Plans in a thread of its own, one plan at a time, so that the control cycle never waits.
class BackgroundPlanner {
 public:
  /// What a plan is made from; all by value, nothing is shared with the thread.
  struct Request {
    BitGrid obstacles;
    Eigen::Vector2d start = Eigen::Vector2d::Zero();
    Goal goal;
    Settings settings;
  };

  /// Starts planning. @pre not busy.
  void start(Request request);

  /// Whether a plan is being made, or is made and was not taken yet.
  [[nodiscard]] bool busy() const noexcept { return pending_.valid(); }

  /// The plan, once it is made; with `wait` as soon as it is made.
  [[nodiscard]] std::optional<Plan> take(bool wait = false);

 private:
  Planner planner_;            // used by the thread only, while there is one
  std::future<Plan> pending_;  // its end is waited for on destruction
};

}  // namespace fairway::bridge
