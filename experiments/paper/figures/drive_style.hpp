// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "experiments/paper/studies/drive_study.hpp"
#include "fairway/io/drawing/canvas.hpp"

namespace fairway::reproduction {

/// The colour of a driver in every figure.
[[nodiscard]] io::Color color_of(DriverKind kind);

/// The line style of a driver's trajectory; styles differ so that colour is not needed.
[[nodiscard]] io::Stroke track_stroke(DriverKind kind);

/// The positions along a drive.
[[nodiscard]] std::vector<Eigen::Vector2d> track_of(const Drive& drive);

}  // namespace fairway::reproduction
