// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <mutex>

#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/navigation/settings.hpp"
#include "mpc/problem_tables.hpp"
#include "mpc/trajectory_arrays.hpp"

namespace fairway::python {

namespace {

InitialGuess read_guess(const py::object& commands) {
  InitialGuess guess;
  if (commands.is_none()) return guess;
  const NumberTable table = read_table(commands, "guess", 2);
  guess.count = static_cast<int>(std::min<std::size_t>(table.rows, kMaxHorizon));
  for (std::size_t k = 0; k < static_cast<std::size_t>(guess.count); ++k)
    guess.commands[k] = {.linear = table.row(k)[0], .angular = table.row(k)[1]};
  return guess;
}

/// A solver that keeps its memory from one problem to the next.
class Solver {
 public:
  explicit Solver(const std::optional<Settings>& settings)
      : solver_(checked(settings.value_or(Settings{})).mpc) {}

  [[nodiscard]] MpcSolution solve(const ControlProblem& problem, const py::object& commands) {
    const InitialGuess guess = read_guess(commands);
    const py::gil_scoped_release release;
    const std::scoped_lock lock(mutex_);
    return solver_.solve(problem, guess);
  }

 private:
  std::mutex mutex_;
  RealTimeSolver solver_;
};

py::tuple limiting_constraint(const MpcSolution& solution) {
  const ConstraintName& name = solution.limiting;
  return py::make_tuple(to_text(name.kind), name.step, name.index);
}

void bind_solution(py::module_& module) {
  using enum SolveStatus;
  py::enum_<SolveStatus>(module, "SolveStatus", "Reason why a solve ended.")
      .value("Solved", Solved)
      .value("LeastViolation", LeastViolation)
      .value("IterationLimit", IterationLimit)
      .value("Stalled", Stalled)
      .value("InvalidProblem", InvalidProblem)
      .def_property_readonly(
          "text", [](SolveStatus status) { return to_text(status); },
          "As files of the tool write it.");
  py::class_<MpcSolution>(module, "Solution",
                          "The result of a solver: finite, and within the hard constraints.")
      .def_readonly("status", &MpcSolution::status, "What became of the solve.")
      .def_readonly("iterations", &MpcSolution::iterations, "Iterations of the solver.")
      .def_readonly("cost", &MpcSolution::cost, "Objective without the penalty of violations.")
      .def_readonly("max_violation", &MpcSolution::max_violation,
                    "Greatest violation of a soft constraint [m or m^2].")
      .def_readonly("sum_violation", &MpcSolution::sum_violation, "Sum of the violations.")
      .def_property_readonly("limiting", &limiting_constraint,
                             "Kind, step and index of the constraint that limits most.")
      .def_property_readonly("commands", &commands_array, "N x 2: linear, angular.")
      .def_property_readonly("poses", &poses_array, "(N + 1) x 3: x, y, heading; row 0 is start.");
}

}  // namespace

void bind_solver(py::module_& module) {
  bind_solution(module);
  py::class_<Solver>(module, "Solver",
                     "The real-time interior-point solver; keeps its memory between problems.")
      .def(py::init<const std::optional<Settings>&>(), py::arg("settings") = py::none())
      .def("solve", &Solver::solve, py::arg("problem"), py::arg("guess") = py::none(),
           "Solves a problem from a guess: commands, n x 2, the last one repeated; None: cold.");
  module.def(
      "solve",
      [](const ControlProblem& problem, const py::object& guess,
         const std::optional<Settings>& settings) {
        return Solver(settings).solve(problem, guess);
      },
      py::arg("problem"), py::arg("guess") = py::none(), py::arg("settings") = py::none(),
      "Solves one problem; see Solver.solve.");
  module.def(
      "step",
      [](const Pose2& pose, const Twist2& command, double dt, const std::string& integration) {
        ControlProblem problem;
        set_integration(problem, integration);
        return step(pose, command, dt, problem.integration);
      },
      py::arg("pose"), py::arg("command"), py::arg("dt"), py::arg("integration") = "midpoint",
      "Returns the pose after a unicycle has executed a command for `dt` [s].");
}

}  // namespace fairway::python
