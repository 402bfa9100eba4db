// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/mpc/problem_from_settings.hpp"
#include "fairway/navigation/settings.hpp"
#include "mpc/problem_tables.hpp"

namespace fairway::python {

namespace {

ControlProblem make_problem(int horizon, double dt, const std::string& integration) {
  ControlProblem problem;
  problem.horizon = checked_horizon(horizon);
  problem.dt = dt;
  set_integration(problem, integration);
  return problem;
}

ControlProblem from_settings(const Settings& settings, const Twist2& last_command) {
  ControlProblem problem;
  const Settings& valid = checked(settings);
  set_from_settings(valid.mpc, valid.robot, last_command, problem);
  return problem;
}

// The two weights of commands as a tuple.
template <Eigen::Vector2d ControlProblem::*kWeight>
void bind_weight(py::class_<ControlProblem>& type, const char* name, const char* doc) {
  type.def_property(
      name, [](const ControlProblem& p) { return p.*kWeight; },
      [](ControlProblem& p, const Eigen::Vector2d& weight) { p.*kWeight = weight; }, doc);
}

}  // namespace

void bind_problem(py::module_& module) {
  using Problem = ControlProblem;
  py::class_<Problem> type(module, "Problem",
                           "One optimal control problem, Eq. (15) of the paper. Targets, regions "
                           "and obstacles are given for the steps of the horizon; corridor and "
                           "obstacles are soft constraints, the limits of commands are hard.");
  type.def(py::init(&make_problem), py::arg("horizon") = 10, py::arg("dt") = 0.1,
           py::arg("integration") = "midpoint")
      .def_static("from_settings", &from_settings, py::arg("settings"),
                  py::arg("last_command") = Twist2{},
                  "Makes a problem with horizon, model, limits and weights of the settings.")
      .def_readonly("horizon", &Problem::horizon, "Number of steps, N.")
      .def_readwrite("dt", &Problem::dt, "Length of a step [s].")
      .def_property("integration", &integration_name, &set_integration, "euler or midpoint.")
      .def_readwrite("start", &Problem::start, "Pose at step 0: x, y [m], heading [rad].")
      .def_readwrite("command_min", &Problem::command_min, "Least command [m/s, rad/s].")
      .def_readwrite("command_max", &Problem::command_max, "Greatest command [m/s, rad/s].")
      .def_readwrite("previous_command", &Problem::previous_command,
                     "The command being executed [m/s, rad/s].")
      .def_readwrite("max_change", &Problem::max_change,
                     "Greatest change from one command to the next; infinite: no limit.")
      .def_readwrite("stop_at_end", &Problem::stop_at_end, "Whether the last command is zero.")
      .def_readwrite("penalise_first_change", &Problem::penalise_first_change,
                     "Whether the change from the present command to the first one costs.")
      .def_readwrite("barrier_retention", &Problem::barrier_retention, "1 - gamma dt, in [0, 1).")
      .def_readwrite("violation_weight", &Problem::violation_weight,
                     "Penalty of a violation of one metre.")
      .def_property("targets", &targets_table, &set_targets,
                    "Target poses of steps 1 to N, N x 3: x, y [m], heading [rad].")
      .def_property("target_weights", &weights_table, &set_weights,
                    "Weights of the targets, N x 3, or one row for all steps.")
      .def("set_region", &set_region, py::arg("step"), py::arg("rectangles"),
           "Sets the one or two rectangles that contain the robot's centre at a step; none: no "
           "constraint.")
      .def("set_corridor", &set_corridor, py::arg("rectangle"),
           "Sets the same rectangle for every step.")
      .def("add_obstacle", &add_obstacle, py::arg("positions"), py::arg("keep_out"),
           "Adds a moving obstacle: its positions at steps 0 to N, (N + 1) x 2 [m], and the least "
           "distance between the centres [m].")
      .def_readonly("num_obstacles", &Problem::num_obstacles, "Number of moving obstacles.");
  bind_weight<&Problem::command_weight>(type, "command_weight", "R, linear and angular.");
  bind_weight<&Problem::change_weight>(type, "change_weight", "S, linear and angular.");
}

}  // namespace fairway::python
