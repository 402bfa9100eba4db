// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway::ros1 {

/// Handles SIGINT, SIGTERM and the `shutdown` call of `rosnode kill`. The node can then brake and
/// send zero commands before it ends. ROS's own handlers would close the connections first. Call it
/// after ros::init (with NoSigintHandler) and before the first node handle.
void take_over_exit();

/// Whether the node has been requested to end.
[[nodiscard]] bool exit_wanted() noexcept;

/// Whether that was requested a second time: end at once.
[[nodiscard]] bool exit_urgent() noexcept;

}  // namespace fairway::ros1
