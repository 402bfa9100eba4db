// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/interior_point/initial_point.hpp"

#include <algorithm>

namespace fairway::interior_point {
namespace {

// Shares by which a guess, and the drive that replaces a missing guess, move to the middle of the
// bounds.
constexpr double kInwards = 0.005;
constexpr double kDriveInwards = 0.1;

// Clips the commands to what can be reached, and moves them by a share of the distance to its
// middle.
void move_inwards(double share, const Workspace& w, Point& point) noexcept {
  for (std::size_t j = 0; j < 2; ++j) {
    double* commands = point.commands[j].data() + 1;
    const CommandLimits& limits = w.limits[j];
    clip_to_reach(limits, static_cast<int>(w.horizon), commands);
    for (std::size_t k = 0; k < w.horizon; ++k) {
      const double middle = 0.5 * (limits.reach_low[k] + limits.reach_high[k]);
      commands[k] += share * (middle - commands[k]);
      if (limits.fixed[k]) commands[k] = limits.low[k];
    }
  }
}

}  // namespace

void load_guess(const SimdKernels& kernels,
                const InitialGuess& guess,
                const Workspace& w,
                Point& point) noexcept {
  const auto given = static_cast<std::size_t>(std::clamp(guess.count, 0, kMaxHorizon));
  if (given == 0) static_cast<void>(kernels.drive_to_targets(w, DriveStart::Any, point));
  for (std::size_t k = 0; given > 0 && k < w.horizon; ++k) {
    const Twist2& command = guess.commands[std::min(k, given - 1)];
    point.commands[kLinear][k + 1] = command.linear;
    point.commands[kAngular][k + 1] = command.angular;
  }
  move_inwards(given > 0 ? kInwards : kDriveInwards, w, point);
}

Drive load_drive(const SimdKernels& kernels,
                 DriveStart wanted,
                 const Workspace& w,
                 Point& point) noexcept {
  const Drive drive = kernels.drive_to_targets(w, wanted, point);
  move_inwards(kDriveInwards, w, point);
  return drive;
}

}  // namespace fairway::interior_point
