// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/solution.hpp"
#include "numbers.hpp"

namespace fairway::python {

/// The poses of a solution: x, y, heading at steps 0 to its horizon.
[[nodiscard]] inline py::array_t<double> poses_array(const MpcSolution& solution) {
  const auto count = static_cast<std::size_t>(solution.horizon) + 1;
  py::array_t<double> array = new_table(count, 3);
  double* out = array.mutable_data();
  for (std::size_t k = 0; k < count; ++k) {
    *out++ = solution.poses[k].position.x();
    *out++ = solution.poses[k].position.y();
    *out++ = solution.poses[k].heading;
  }
  return array;
}

/// The commands of a solution: linear, angular at steps 0 to its horizon - 1.
[[nodiscard]] inline py::array_t<double> commands_array(const MpcSolution& solution) {
  const auto count = static_cast<std::size_t>(solution.horizon);
  py::array_t<double> array = new_table(count, 2);
  double* out = array.mutable_data();
  for (std::size_t k = 0; k < count; ++k) {
    *out++ = solution.commands[k].linear;
    *out++ = solution.commands[k].angular;
  }
  return array;
}

}  // namespace fairway::python
