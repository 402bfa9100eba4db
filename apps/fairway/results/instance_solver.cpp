// SPDX-License-Identifier: Apache-2.0
#include "results/instance_solver.hpp"

#include "cli/left_out.hpp"
#include "fairway/mpc/interior_point/four_start_solver.hpp"

#ifdef FAIRWAY_HAS_IPOPT
#include "fairway/mpc/ipopt/ipopt_solver.hpp"
#endif

namespace fairway::app {

namespace {

class InteriorPoint final : public InstanceSolver {
 public:
  const MpcSolution& solve(const ControlProblem& problem,
                           std::span<const InitialGuess> guesses) override {
    const InteriorPointSettings settings =
        guesses.front().count > 0 ? InteriorPointSettings::warm() : InteriorPointSettings{};
    if (guesses.size() == 1) return solver_.single().solve(problem, guesses.front(), settings);
    if (guesses.size() == 4) return solver_.solve(problem, guesses.front(), settings);
    return solver_.single().solve_best(problem, guesses, settings);
  }

 private:
  FourStartSolver solver_;
};

#ifdef FAIRWAY_HAS_IPOPT

class Ipopt final : public InstanceSolver {
 public:
  explicit Ipopt(IpoptConstraints constraints) : solver_({.constraints = constraints}) {}

  const MpcSolution& solve(const ControlProblem& problem,
                           std::span<const InitialGuess> guesses) override {
    int iterations = 0;
    for (std::size_t i = 0; i < guesses.size(); ++i) {
      const MpcSolution& solution = solver_.solve(problem, guesses[i]);
      iterations += solution.iterations;
      if (i == 0 || is_better(problem, solution, best_)) best_ = solution;
    }
    best_.iterations = iterations;
    return best_;
  }

 private:
  static bool is_better(const ControlProblem& problem, const MpcSolution& a, const MpcSolution& b) {
    const bool a_solved = a.status == SolveStatus::Solved;
    const bool b_solved = b.status == SolveStatus::Solved;
    if (a_solved != b_solved) return a_solved;
    return a.cost + problem.violation_weight * a.sum_violation <
           b.cost + problem.violation_weight * b.sum_violation;
  }

  IpoptSolver solver_;
  MpcSolution best_;
};

#endif

}  // namespace

Expected<std::unique_ptr<InstanceSolver>> make_instance_solver(const std::string& name) {
  if (name == "interior_point") return std::make_unique<InteriorPoint>();
#ifdef FAIRWAY_HAS_IPOPT
  if (name == "ipopt") return std::make_unique<Ipopt>(IpoptConstraints::Soft);
  if (name == "ipopt_hard") return std::make_unique<Ipopt>(IpoptConstraints::Hard);
#endif
  return fail("--solver: expected interior_point, found " + name + ", " +
              left_out("coinor-libipopt-dev"));
}

}  // namespace fairway::app
