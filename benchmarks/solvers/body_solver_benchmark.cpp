// SPDX-License-Identifier: Apache-2.0
// Measures the solver for true bodies, and prints Markdown tables on standard output.
//   body_solver_benchmark times [PROBLEMS [REPEATS]]
//   body_solver_benchmark ipopt [PROBLEMS [SEED]]
// `times` compares a rectangle with a disc in the same scenes; the fastest of REPEATS (default 20)
// counts. `ipopt` compares the solver with IPOPT on PROBLEMS random problems of each base.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "experiments/clocks.hpp"
#include "fairway/mpc/interior_point/body/body_solver.hpp"
#include "fairway/mpc/interior_point/solver.hpp"
#include "fairway/mpc/ipopt/ipopt_body_solver.hpp"
#include "support/random/random_body_problem.hpp"

namespace fairway::benchmark {
namespace {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

// Calls solve() repeatedly; returns the fastest time [us].
template <typename Solve>
double fastest(int repeats, const Solve& solve) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const double begin = thread_cpu_seconds();
    solve();
    best = std::min(best, 1e6 * (thread_cpu_seconds() - begin));
  }
  return best;
}

// Problem of a disc as wide as the body, in the rectangles of the body.
ControlProblem as_disc(const BodyProblem<UnicycleMotion>& body) {
  const double radius = std::abs(body.points[0].y());
  ControlProblem disc;
  disc.horizon = body.horizon;
  disc.dt = body.dt;
  disc.integration = Integration::Midpoint;
  disc.start = body.start;
  const auto twist = [](const Eigen::Vector2d& v) { return Twist2{v[0], v[1]}; };
  disc.command_min = twist(body.input_min);
  disc.command_max = twist(body.input_max);
  disc.previous_command = twist(body.previous_input);
  disc.max_change = twist(body.max_change);
  disc.targets = body.targets;
  disc.command_weight = body.input_weight;
  disc.change_weight = body.change_weight;
  disc.penalise_first_change = body.penalise_first_change;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(body.horizon); ++k) {
    disc.regions[k].count = body.regions[k].count;
    for (std::size_t i = 0; i < kMaxRectanglesPerStep; ++i)
      disc.regions[k].rectangles[i] = body.regions[k].rectangles[i].shrunk(radius);
  }
  disc.num_obstacles = body.num_obstacles;
  disc.obstacles = body.obstacles;
  for (PredictedObstacle& obstacle : disc.obstacles) {
    for (double& keep_out : obstacle.keep_out)
      keep_out += radius;
  }
  return disc;
}

// The next cycle: the robot has followed the first input nearly, and all references move up.
template <typename Problem>
Problem next_cycle(const Problem& problem, const Pose2& start) {
  Problem next = problem;
  next.start = start;
  next.start.position += Eigen::Vector2d(0.003, -0.002);
  const auto last = static_cast<std::size_t>(problem.horizon);
  for (std::size_t k = 1; k < last; ++k) {
    next.targets[k] = problem.targets[k + 1];
    next.regions[k] = problem.regions[k + 1];
  }
  for (PredictedObstacle& obstacle : next.obstacles) {
    std::copy(obstacle.position.begin() + 1, obstacle.position.end(), obstacle.position.begin());
    obstacle.position[last] = 2.0 * obstacle.position[last - 1] - obstacle.position[last - 2];
  }
  return next;
}

struct Times {
  std::vector<double> cold, warm;  // [us]
  double iterations = 0.0;
  int solved = 0;
};

void time_disc(const BodyProblem<UnicycleMotion>& body,
               int repeats,
               InteriorPointSolver& solver,
               Times& times) {
  const ControlProblem problem = as_disc(body);
  const MpcSolution first = solver.solve(problem);
  times.iterations += first.iterations;
  times.solved += first.status == SolveStatus::Solved ? 1 : 0;
  times.cold.push_back(fastest(repeats, [&] { solver.solve(problem); }));
  ControlProblem next = next_cycle(problem, first.poses[1]);
  next.previous_command = first.commands[0];
  InitialGuess guess{.count = problem.horizon - 1, .commands = {}};
  std::copy_n(first.commands.begin() + 1, guess.count, guess.commands.begin());
  times.warm.push_back(
      fastest(repeats, [&] { solver.solve(next, guess, InteriorPointSettings::warm()); }));
}

template <typename Motion>
void time_body(const BodyProblem<Motion>& problem,
               int repeats,
               BodySolver<Motion>& solver,
               Times& times) {
  const BodySolution<Motion> first = solver.solve(problem);
  times.iterations += first.iterations;
  times.solved += first.status == SolveStatus::Solved ? 1 : 0;
  times.cold.push_back(fastest(repeats, [&] { solver.solve(problem); }));
  BodyProblem<Motion> next = next_cycle(problem, first.poses[1]);
  next.previous_input = first.inputs[0];
  BodyGuess<Motion> guess;
  guess.count = problem.horizon - 1;
  std::copy_n(first.inputs.begin() + 1, guess.count, guess.inputs.begin());
  times.warm.push_back(
      fastest(repeats, [&] { solver.solve(next, guess, InteriorPointSettings::warm()); }));
}

void print_times(const char* name, const Times& times, const Times& disc) {
  const auto column = [](const std::vector<double>& own, const std::vector<double>& other) {
    std::printf(" %.1f / %.1f | %.2f |", quantile(own, 0.5), quantile(own, 0.99),
                quantile(own, 0.5) / quantile(other, 0.5));
  };
  const auto count = static_cast<double>(times.cold.size());
  std::printf("| %s | %d of %zu | %.1f |", name, times.solved, times.cold.size(),
              times.iterations / count);
  column(times.cold, disc.cold);
  column(times.warm, disc.warm);
  std::printf("\n");
  std::fflush(stdout);
}

// Rows of one base: all that the random problems have.
template <typename Motion>
Times time_base(const test::BodyProblemKind& kind, int count, int repeats) {
  const auto solver = std::make_unique<BodySolver<Motion>>();
  test::RandomBodyProblems problems(5);
  Times times;
  for (int i = 0; i < count; ++i)
    time_body(problems.next<Motion>(kind), repeats, *solver, times);
  return times;
}

void run_times(int count, int repeats) {
  const auto disc_solver = std::make_unique<InteriorPointSolver>();
  const auto body_solver = std::make_unique<BodySolver<UnicycleMotion>>();
  for (const int obstacles : {0, 2}) {
    const test::BodyProblemKind kind = {.obstacles = obstacles, .overlap = true};
    test::RandomBodyProblems problems(5);
    Times disc;
    Times vertices;
    Times cuts;
    for (int i = 0; i < count; ++i) {
      BodyProblem<UnicycleMotion> problem = problems.next<UnicycleMotion>(kind);
      problem.num_input_limits = 0;
      time_disc(problem, repeats, *disc_solver, disc);
      time_body(problem, repeats, *body_solver, cuts);
      problem.num_points = 4;
      time_body(problem, repeats, *body_solver, vertices);
    }
    std::printf(
        "\n| horizon 20, two rectangles at every step, %d obstacles | solved | iterations |"
        " cold: median / p99 us | ratio | warm | ratio |\n|---|---|---|---|---|---|---|\n",
        obstacles);
    print_times("disc", disc, disc);
    print_times("unicycle, 4 vertices", vertices, disc);
    print_times("unicycle, 4 vertices, 2 cut points", cuts, disc);
    print_times("the same, two wheel speeds", time_base<UnicycleMotion>(kind, count, repeats),
                disc);
    print_times("steered, 4 vertices, 2 cut points", time_base<SteeredMotion>(kind, count, repeats),
                disc);
    print_times("omnidirectional, 2 cut points, 4 wheel speeds",
                time_base<OmniMotion>(kind, count, repeats), disc);
  }
}

// Agreement with IPOPT.
struct Agreement {
  int feasible = 0, missed = 0, only_ours = 0;  // problems with a feasible point by either solver
  int missed_after_restarts = 0;
  int near = 0, better = 0;               // of those that both solve
  int near_first = 0;                     // with IPOPT started from our solution
  int converged = 0, near_violation = 0;  // problems without a feasible point
  std::vector<double> ours, ipopt;        // [us]
};

template <typename Motion>
double penalised_cost(const BodyProblem<Motion>& problem, const BodySolution<Motion>& solution) {
  return solution.cost + problem.violation_weight * solution.sum_violation;
}

template <typename Motion>
void compare(const BodyProblem<Motion>& problem,
             BodySolver<Motion>& solver,
             IpoptBodySolver<Motion>& reference,
             Agreement& sum) {
  constexpr double kNear = 1e-3;  // within 0.1 %
  double begin = thread_cpu_seconds();
  const BodySolution<Motion> ours = solver.solve(problem);
  sum.ours.push_back(1e6 * (thread_cpu_seconds() - begin));
  begin = thread_cpu_seconds();
  const BodySolution<Motion> theirs = reference.solve(problem);
  sum.ipopt.push_back(1e6 * (thread_cpu_seconds() - begin));
  const bool we_solved = ours.status == SolveStatus::Solved;
  const bool they_solved = theirs.status == SolveStatus::Solved;
  const double cost = penalised_cost(problem, ours);
  const double best = penalised_cost(problem, theirs);
  if (!we_solved && !they_solved) {
    if (ours.status != SolveStatus::LeastViolation || theirs.status != SolveStatus::LeastViolation)
      return;
    ++sum.converged;
    if (cost <= best * (1.0 + kNear)) ++sum.near_violation;
    return;
  }
  ++sum.feasible;
  if (!we_solved) {
    ++sum.missed;
    if (solver.solve_with_restarts(problem).status != SolveStatus::Solved)
      ++sum.missed_after_restarts;
  }
  if (!they_solved) ++sum.only_ours;
  if (!we_solved) return;
  if (they_solved && cost <= best * (1.0 + kNear)) ++sum.near;
  if (they_solved && cost < best * (1.0 - kNear)) ++sum.better;
  // Started from our solution, IPOPT must not find anything better nearby.
  BodyGuess<Motion> guess;
  guess.count = problem.horizon;
  guess.inputs = ours.inputs;
  const BodySolution<Motion>& local = reference.solve(problem, guess);
  if (cost <= penalised_cost(problem, local) * (1.0 + kNear)) ++sum.near_first;
}

template <typename Motion>
void run_ipopt(const char* name, int count, std::uint64_t seed) {
  const auto solver = std::make_unique<BodySolver<Motion>>();
  IpoptBodySolver<Motion> reference;
  for (const int obstacles : {0, 2}) {
    test::RandomBodyProblems problems(seed);
    Agreement sum;
    for (int i = 0; i < count; ++i)
      compare(problems.next<Motion>({.obstacles = obstacles}), *solver, reference, sum);
    std::printf(
        "| %s, %d obstacles | %d | %d | %d | %d | %d | %d | %d | %d | %d | %.0f / %.0f | %.0f |\n",
        name, obstacles, count, sum.feasible, sum.missed, sum.missed_after_restarts, sum.only_ours,
        sum.near, sum.better, sum.near_first,
        sum.converged > 0 ? 100 * sum.near_violation / sum.converged : 0, quantile(sum.ours, 0.5),
        quantile(sum.ipopt, 0.5), quantile(sum.ipopt, 0.5) / quantile(sum.ours, 0.5));
    std::fflush(stdout);
  }
}

int run(int argc, char** argv) {
  const auto number = [&](int i, int otherwise) {
    return argc > i ? std::max(1, std::atoi(argv[i])) : otherwise;
  };
  if (argc > 1 && std::strcmp(argv[1], "ipopt") == 0) {
    const int count = number(2, 100);
    const auto seed = static_cast<std::uint64_t>(number(3, 1));
    std::printf(
        "| base | problems | feasible | missed | with restarts | missed by IPOPT | within 0.1 %% | "
        "better |"
        " IPOPT from our solution agrees | %% of infeasible within 0.1 %% |"
        " median us: ours / IPOPT | ratio |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    run_ipopt<UnicycleMotion>("unicycle", count, seed);
    run_ipopt<SteeredMotion>("steered", count, seed);
    run_ipopt<OmniMotion>("omnidirectional", count, seed);
    return 0;
  }
  if (argc > 1 && std::strcmp(argv[1], "times") == 0) {
    run_times(number(2, 100), number(3, 20));
    return 0;
  }
  std::fprintf(
      stderr,
      "usage: body_solver_benchmark times [PROBLEMS [REPEATS]] | ipopt [PROBLEMS [SEED]]\n");
  return 2;
}

}  // namespace
}  // namespace fairway::benchmark

int main(int argc, char** argv) { return fairway::benchmark::run(argc, argv); }
