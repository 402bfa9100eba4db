// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/control/body_control.hpp"

namespace fairway {

BodyControl::BodyControl(const RobotModel& robot,
                         const MpcSettings& mpc,
                         double period,
                         double margin) {
  const auto use = [&](auto motion) {
    using Motion = decltype(motion);
    control_ = std::make_unique<DriveControl<Motion>>(robot.base, robot.body, mpc, period, margin);
  };
  if (robot.base.kind == BaseKind::Omni) {
    use(OmniMotion{});
  } else if (is_steered(robot.base)) {
    use(SteeredMotion{});
  } else {
    use(UnicycleMotion{});
  }
}

void BodyControl::forget() noexcept {
  std::visit([](auto& control) { control->forget(); }, control_);
}

DriveChoice BodyControl::choose(const DriveView& view) noexcept {
  return std::visit([&](auto& control) { return control->choose(view); }, control_);
}

}  // namespace fairway
