// SPDX-License-Identifier: Apache-2.0
#include "mpc/problem_tables.hpp"

#include <algorithm>

namespace fairway::python {

namespace {

std::size_t steps(const ControlProblem& problem) {
  return static_cast<std::size_t>(problem.horizon);
}

// A table with a row for each step, or with a single one where that is allowed.
NumberTable read_steps(const py::object& source,
                       const char* name,
                       std::size_t rows,
                       std::size_t columns,
                       bool one_will_do) {
  const py::object given = py::module_::import("numpy").attr("atleast_2d")(source);
  NumberTable table = read_table(given, name, columns);
  if (table.rows != rows && !(one_will_do && table.rows == 1)) {
    refuse(name, "an array of " + std::to_string(rows) + " x " + std::to_string(columns),
           given.attr("shape"));
  }
  return table;
}

}  // namespace

int checked_horizon(int horizon) {
  if (horizon < 1 || horizon > kMaxHorizon) {
    refuse("horizon", "an integer from 1 to " + std::to_string(kMaxHorizon), py::int_(horizon));
  }
  return horizon;
}

std::string integration_name(const ControlProblem& problem) {
  return problem.integration == Integration::Euler ? "euler" : "midpoint";
}

void set_integration(ControlProblem& problem, const std::string& name) {
  if (name != "euler" && name != "midpoint")
    refuse("integration", "euler or midpoint", py::str(name));
  problem.integration = name == "euler" ? Integration::Euler : Integration::Midpoint;
}

py::array_t<double> targets_table(const ControlProblem& problem) {
  py::array_t<double> table = new_table(steps(problem), 3);
  double* out = table.mutable_data();
  for (std::size_t k = 1; k <= steps(problem); ++k) {
    *out++ = problem.targets[k].position.x();
    *out++ = problem.targets[k].position.y();
    *out++ = problem.targets[k].heading;
  }
  return table;
}

void set_targets(ControlProblem& problem, const py::object& targets) {
  const NumberTable table = read_steps(targets, "targets", steps(problem), 3, false);
  for (std::size_t k = 1; k <= steps(problem); ++k) {
    const double* const row = table.row(k - 1);
    problem.targets[k].position = {row[0], row[1]};
    problem.targets[k].heading = row[2];
  }
}

py::array_t<double> weights_table(const ControlProblem& problem) {
  py::array_t<double> table = new_table(steps(problem), 3);
  double* out = table.mutable_data();
  for (std::size_t k = 1; k <= steps(problem); ++k)
    out = std::copy_n(problem.targets[k].weight.data(), 3, out);
  return table;
}

void set_weights(ControlProblem& problem, const py::object& weights) {
  const NumberTable table = read_steps(weights, "target_weights", steps(problem), 3, true);
  for (std::size_t k = 1; k <= steps(problem); ++k)
    std::copy_n(table.row(table.rows == 1 ? 0 : k - 1), 3, problem.targets[k].weight.data());
}

void set_region(ControlProblem& problem,
                int step,
                const std::vector<OrientedRectangle>& rectangles) {
  if (step < 1 || step > problem.horizon) {
    refuse("step", "an integer from 1 to " + std::to_string(problem.horizon), py::int_(step));
  }
  StepRegion& region = problem.regions[static_cast<std::size_t>(step)];
  if (rectangles.size() > region.rectangles.size())
    refuse("rectangles", "at most two", py::int_(rectangles.size()));
  std::copy(rectangles.begin(), rectangles.end(), region.rectangles.begin());
  region.count = static_cast<int>(rectangles.size());
}

void set_corridor(ControlProblem& problem, const OrientedRectangle& rectangle) {
  for (int k = 1; k <= problem.horizon; ++k)
    set_region(problem, k, {rectangle});
}

void add_obstacle(ControlProblem& problem, const py::object& positions, double keep_out) {
  if (problem.num_obstacles >= kMaxObstacles) {
    refuse("obstacles", "at most " + std::to_string(kMaxObstacles),
           py::int_(problem.num_obstacles + 1));
  }
  const NumberTable table = read_steps(positions, "positions", steps(problem) + 1, 2, true);
  PredictedObstacle& obstacle =
      problem.obstacles[static_cast<std::size_t>(problem.num_obstacles++)];
  for (std::size_t k = 0; k <= steps(problem); ++k) {
    const double* const row = table.row(table.rows == 1 ? 0 : k);
    obstacle.position[k] = {row[0], row[1]};
    obstacle.keep_out[k] = keep_out;
  }
}

}  // namespace fairway::python
