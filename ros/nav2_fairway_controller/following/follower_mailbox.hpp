// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "nav2_fairway_controller/following/following_settings.hpp"
#include "nav2_fairway_controller/following/speed_limit.hpp"

namespace fairway::nav2 {

/// A path in its own frame.
struct PathTask {
  Path path;
  std::optional<double> goal_heading;  ///< in the same frame [rad]
  /// Headings of the waypoints [rad], NaN where one has none; a disc needs none of them.
  std::vector<double> headings{};
};

/// The changes since the last cycle, in the order in which they apply.
struct FollowerChanges {
  bool reset = false;
  std::optional<FollowerSettings> settings;
  std::optional<SpeedLimit> limit;
  std::optional<PathTask> path;
  bool cancel = false;
};

/// Collects changes from any thread until the next control cycle takes them. No call waits longer
/// than for a copy; a later change replaces an earlier one of its kind.
class FollowerMailbox {
 public:
  void post_settings(const FollowerSettings& settings) {
    const std::lock_guard<std::mutex> lock(mutex_);
    changes_.settings = settings;
  }

  void post_limit(const SpeedLimit& limit) {
    const std::lock_guard<std::mutex> lock(mutex_);
    changes_.limit = limit;
  }

  void post_path(PathTask path) {
    const std::lock_guard<std::mutex> lock(mutex_);
    changes_.path = std::move(path);
    changes_.cancel = false;
  }

  void post_cancel() {
    const std::lock_guard<std::mutex> lock(mutex_);
    changes_.path.reset();
    changes_.cancel = true;
  }

  void post_reset() {
    const std::lock_guard<std::mutex> lock(mutex_);
    changes_.path.reset();
    changes_.cancel = false;
    changes_.reset = true;
  }

  /// Takes all changes.
  [[nodiscard]] FollowerChanges take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(changes_, {});
  }

 private:
  std::mutex mutex_;
  FollowerChanges changes_;
};

}  // namespace fairway::nav2
