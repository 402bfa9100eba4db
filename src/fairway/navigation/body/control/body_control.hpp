// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <variant>

#include "fairway/geometry/robot_model.hpp"
#include "fairway/navigation/body/control/drive_control.hpp"

namespace fairway {

/// Model predictive control of a robot of any base: the solver that was compiled for it, chosen at
/// construction.
class BodyControl {
 public:
  /// @param period  Of control [s].
  /// @param margin  Distance of the body to the sides of rectangles [m].
  BodyControl(const RobotModel& robot, const MpcSettings& mpc, double period, double margin);

  /// Forgets the solution of the cycle before: the robot follows another drive.
  void forget() noexcept;

  /// Looks for a motion of less cost than that of the follower. Does not allocate.
  /// @pre `view` has a drive, its space, and obstacles.
  [[nodiscard]] DriveChoice choose(const DriveView& view) noexcept;

 private:
  template <typename Motion>
  using Control = std::unique_ptr<DriveControl<Motion>>;
  std::variant<Control<UnicycleMotion>, Control<SteeredMotion>, Control<OmniMotion>> control_;
};

}  // namespace fairway
