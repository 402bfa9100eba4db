// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/limiting_factor.hpp"

namespace fairway {

LimitingFactor limit_of(StopVerdict verdict) noexcept {
  switch (verdict) {
    case StopVerdict::EntersZone:
      return LimitingFactor::KeepOutZone;
    case StopVerdict::LeavesStrip:
      return LimitingFactor::Strip;
    case StopVerdict::TooFast:
      return LimitingFactor::SpeedZone;
    case StopVerdict::WrongWay:
      return LimitingFactor::OneWayZone;
    case StopVerdict::Free:
    case StopVerdict::HitsStatic:
    case StopVerdict::HitsMoving:
      break;
  }
  return LimitingFactor::StopNotProven;
}

LimitingFactor limit_of(const ConstraintName& constraint) noexcept {
  switch (constraint.kind) {
    case ConstraintKind::None:
      return LimitingFactor::None;
    case ConstraintKind::LinearSpeed:
    case ConstraintKind::AngularSpeed:
      return LimitingFactor::Speed;
    case ConstraintKind::LinearChange:
    case ConstraintKind::AngularChange:
      return LimitingFactor::Acceleration;
    case ConstraintKind::Corridor:
      return LimitingFactor::Corridor;
    case ConstraintKind::Barrier:
      return LimitingFactor::MovingObstacle;
  }
  return LimitingFactor::None;
}

}  // namespace fairway
