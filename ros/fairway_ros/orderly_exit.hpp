// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway::ros1 {

/// Takes over SIGINT, SIGTERM and the `shutdown` call of `rosnode kill`, so that a node can brake
/// and say zero before it goes; ROS's own handlers cut the connections first. Call it after
/// ros::init (with NoSigintHandler) and before the first node handle.
void take_over_exit();

/// Whether someone wants the node to end.
[[nodiscard]] bool exit_wanted() noexcept;

/// Whether someone wants that for the second time: at once.
[[nodiscard]] bool exit_urgent() noexcept;

}  // namespace fairway::ros1
