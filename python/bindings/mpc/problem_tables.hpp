// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "bindings.hpp"
#include "fairway/mpc/control_problem.hpp"
#include "numbers.hpp"

/// The parts of a control problem as arrays, with one row per step. Each setter throws
/// py::value_error for a wrong shape and then changes nothing.
namespace fairway::python {

[[nodiscard]] int checked_horizon(int horizon);

[[nodiscard]] std::string integration_name(const ControlProblem& problem);
void set_integration(ControlProblem& problem, const std::string& name);

[[nodiscard]] py::array_t<double> targets_table(const ControlProblem& problem);
void set_targets(ControlProblem& problem, const py::object& targets);

[[nodiscard]] py::array_t<double> weights_table(const ControlProblem& problem);
void set_weights(ControlProblem& problem, const py::object& weights);

void set_region(ControlProblem& problem,
                int step,
                const std::vector<OrientedRectangle>& rectangles);
void set_corridor(ControlProblem& problem, const OrientedRectangle& rectangle);

void add_obstacle(ControlProblem& problem, const py::object& positions, double keep_out);

}  // namespace fairway::python
