// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

#include "fairway/geometry/pose2.hpp"
#include "fairway/simulation/people/moving_body.hpp"
#include "numbers.hpp"

namespace fairway::python {

/// Makes a body that moves along key frames: time, x, y, with increasing times.
/// @throws py::value_error without a key frame, or if the times do not increase.
[[nodiscard]] inline MovingBody make_body(
    const py::object& key_frames, double radius, const std::string& name, bool loop, bool passing) {
  MovingBody body{
      .name = name, .radius = radius, .key_frames = {}, .loop = loop, .passing = passing};
  const NumberTable table = read_table(key_frames, "key_frames", 3);
  for (std::size_t i = 0; i < table.rows; ++i) {
    const double* const n = table.row(i);
    const bool later = i == 0 || n[0] > body.key_frames.back().time;
    if (!later || !is_finite(Eigen::Vector2d(n[1], n[2])) || !std::isfinite(n[0]))
      refuse("key_frames", "finite numbers and increasing times", key_frames);
    body.key_frames.push_back({.time = n[0], .position = {n[1], n[2]}});
  }
  if (body.key_frames.empty()) refuse("key_frames", "at least one row", key_frames);
  return body;
}

}  // namespace fairway::python
