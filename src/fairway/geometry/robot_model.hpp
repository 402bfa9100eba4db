// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/geometry/base_model.hpp"
#include "fairway/geometry/body_shape.hpp"

namespace fairway {

/// A robot with its true outline and its own kind of base.
struct RobotModel {
  BodyShape body = BodyShape::rectangle(1.0, 0.5, 0.5);
  BaseModel base;
};

}  // namespace fairway
