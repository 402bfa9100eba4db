// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/limiting_factor.hpp"

namespace fairway {

LimitingFactor limit_of(const RowName& row) noexcept {
  switch (row.kind) {
    case RowKind::None:
      return LimitingFactor::None;
    case RowKind::LinearSpeed:
    case RowKind::AngularSpeed:
      return LimitingFactor::Speed;
    case RowKind::LinearChange:
    case RowKind::AngularChange:
      return LimitingFactor::Acceleration;
    case RowKind::Corridor:
      return LimitingFactor::Corridor;
    case RowKind::Barrier:
      return LimitingFactor::MovingObstacle;
  }
  return LimitingFactor::None;
}

}  // namespace fairway
