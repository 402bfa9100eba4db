// SPDX-License-Identifier: Apache-2.0
// Runs both solvers on the same problems, and prints Markdown tables on standard output.
//   solver_benchmark [FOLDER [REPEATS]]
// FOLDER holds the instances of data/ocp, which are skipped if absent. Both solvers run REPEATS
// times (default 20); the fastest time counts.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "experiments/clocks.hpp"
#include "experiments/solver/ocp_instances.hpp"
#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/interior_point/solver.hpp"
#include "fairway/mpc/ipopt/ipopt_solver.hpp"
#include "fairway/mpc/start_guesses.hpp"
#include "fairway/simulation/recorded/metrics.hpp"
#include "ocp_generator.hpp"

namespace fairway::benchmark {
namespace {

constexpr double kNear = 1e-3;  // "within 0.1 % of the best known"
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// The results of one solver on one set of problems.
struct Column {
  std::vector<double> times;  // [us]
  int solved = 0;
  int near_best = 0;

  void add(double time, const MpcSolution& solution, double best_cost) {
    times.push_back(time);
    if (solution.status != SolveStatus::Solved) return;
    ++solved;
    if (solution.cost <= best_cost * (1.0 + kNear)) ++near_best;
  }
};

struct Row {
  Column interior_point;
  Column ipopt;
  int feasible = 0;  // problems with a known feasible point
};

// Calls solve() repeatedly; keeps the first answer and the fastest time.
template <typename Solve>
MpcSolution timed(int repeats, double& fastest, Solve&& solve) {
  fastest = std::numeric_limits<double>::infinity();
  MpcSolution first;
  for (int i = 0; i < repeats; ++i) {
    const double begin = thread_cpu_seconds();
    const MpcSolution& solution = solve();
    fastest = std::min(fastest, 1e6 * (thread_cpu_seconds() - begin));
    if (i == 0) first = solution;
  }
  return first;
}

class Contest {
 public:
  explicit Contest(int repeats)
      : repeats_(repeats),
        interior_point_(std::make_unique<InteriorPointSolver>()) {}

  // `best_cost` is NaN if it is unknown; then IPOPT's result replaces it.
  void run(const ControlProblem& problem, const InitialGuess& guess, double best_cost, Row& row) {
    double time = 0.0;
    const MpcSolution reference =
        timed(repeats_, time, [&]() -> const MpcSolution& { return ipopt_.solve(problem, guess); });
    const bool solved = reference.status == SolveStatus::Solved;
    const double best = std::isnan(best_cost) && solved ? reference.cost : best_cost;
    row.ipopt.add(time, reference, best);
    const InteriorPointSettings settings =
        guess.count > 0 ? InteriorPointSettings::warm() : InteriorPointSettings{};
    const MpcSolution ours = timed(repeats_, time, [&]() -> const MpcSolution& {
      return interior_point_->solve(problem, guess, settings);
    });
    row.interior_point.add(time, ours, best);
    if (!std::isnan(best)) ++row.feasible;
  }

  // The interior-point solver's cold answer, without timing.
  MpcSolution answer(const ControlProblem& problem) { return interior_point_->solve(problem, {}); }

  // The interior-point solver alone, from `starts` starts.
  void run_starts(const ControlProblem& problem, std::size_t starts, double best, Row& row) {
    std::vector<InitialGuess> guesses(starts);
    spread_guesses(problem, {}, guesses);
    double time = 0.0;
    const MpcSolution ours = timed(repeats_, time, [&]() -> const MpcSolution& {
      return interior_point_->solve_best(problem, guesses);
    });
    row.interior_point.add(time, ours, best);
    if (!std::isnan(best)) ++row.feasible;
  }

 private:
  int repeats_;
  std::unique_ptr<InteriorPointSolver> interior_point_;
  IpoptSolver ipopt_{{.constraints = IpoptConstraints::Hard}};
};

void print_head(const char* first) {
  std::printf(
      "\n| %s | n | interior point: median / p99 / max us | solved | within 0.1 %% |"
      " IPOPT: median / p99 / max us | solved | within 0.1 %% | ratio of medians |\n",
      first);
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
}

void print_column(const Column& column, int feasible) {
  const Quantiles q = quantiles(column.times);
  std::printf(" %.1f / %.1f / %.1f | %d of %d | %d |", q.median, q.p99, q.max, column.solved,
              feasible, column.near_best);
}

void print_row(const std::string& name, const Row& row) {
  std::printf("| %s | %zu |", name.c_str(), row.interior_point.times.size());
  print_column(row.interior_point, row.feasible);
  if (row.ipopt.times.empty()) {
    std::printf(" | | | |\n");
  } else {
    print_column(row.ipopt, row.feasible);
    std::printf(" %.0f |\n",
                quantiles(row.ipopt.times).median / quantiles(row.interior_point.times).median);
  }
  std::fflush(stdout);
}

// The cost of a best-known result; NaN without one.
double best_cost(const ControlProblem& problem, const io::OcpResult& best) {
  if (best.status != 0) return kUnknown;
  MpcSolution solution;
  std::copy(best.commands.begin(), best.commands.end(), solution.commands.begin());
  assess(problem, solution);
  return solution.cost;
}

InitialGuess as_guess(const io::OcpResult& result) {
  InitialGuess guess;
  guess.count = io::kOcpHorizon;
  std::copy(result.commands.begin(), result.commands.end(), guess.commands.begin());
  return guess;
}

// The initial guess of the next cycle.
InitialGuess shifted(const MpcSolution& solution) {
  InitialGuess guess;
  guess.count = solution.horizon;
  const auto last = static_cast<std::size_t>(solution.horizon - 1);
  for (std::size_t k = 0; k <= last; ++k)
    guess.commands[k] = solution.commands[std::min(k + 1, last)];
  return guess;
}

// One file of instances; `warm` and `best` may be empty. Prints one line for each class of `split`.
struct Files {
  const char* title;
  const char* instances;
  const char* best;
  const char* warm;
  std::size_t starts;  // above 1: the interior-point solver alone
  bool split;
};

bool run_files(const std::string& folder, const Files& files, Contest& contest) {
  const auto instances = io::read_ocp_instances(folder + files.instances);
  if (!instances) {
    std::fprintf(stderr, "%s\n", instances.error().message.c_str());
    return false;
  }
  const auto read = [&](const std::string& name) {
    return name.empty()
               ? std::vector<io::OcpResult>()
               : io::read_ocp_results(folder + name).value_or(std::vector<io::OcpResult>());
  };
  const std::vector<io::OcpResult> best = read(files.best);
  const std::vector<io::OcpResult> warm = read(files.warm);
  std::map<std::string, Row> rows;
  for (std::size_t i = 0; i < instances->size(); ++i) {
    const io::OcpInstance& instance = (*instances)[i];
    const ControlProblem problem = io::control_problem(instance);
    const double known = i < best.size() ? best_cost(problem, best[i]) : kUnknown;
    Row& row = rows[files.split ? instance.kind : ""];
    if (files.starts > 1) {
      contest.run_starts(problem, files.starts, known, row);
    } else {
      contest.run(problem, i < warm.size() ? as_guess(warm[i]) : InitialGuess{}, known, row);
    }
  }
  for (const auto& [kind, row] : rows)
    print_row(kind.empty() ? files.title : std::string(files.title) + ", " + kind, row);
  return true;
}

void run_shared(const std::string& folder, Contest& contest) {
  print_head("shared instances");
  for (const Files& files : {
           Files{"cold", "inst.txt", "inst.best", "", 1, true},
           Files{"8 obstacles", "inst8.txt", "inst8.best", "", 1, false},
           Files{"16 obstacles", "inst16.txt", "inst16.best", "", 1, false},
           Files{"next step, cold", "inst_next.txt", "inst_next.best", "", 1, false},
           Files{"next step, warm", "inst_next.txt", "inst_next.best", "inst_warm.res", 1, false},
           Files{"infeasible", "inst_inf.txt", "", "", 1, false},
           Files{"cold, 3 starts", "inst.txt", "inst.best", "", 3, false},
           Files{"8 obstacles, 3 starts", "inst8.txt", "inst8.best", "", 3, false},
           Files{"16 obstacles, 3 starts", "inst16.txt", "inst16.best", "", 3, false},
           Files{"next step, 3 starts", "inst_next.txt", "inst_next.best", "", 3, false},
       }) {
    if (!run_files(folder, files, contest)) return;
  }
}

void run_generated(Contest& contest) {
  constexpr int kProblems = 40;
  print_head("generated problems (best = IPOPT's)");
  for (const int horizon : {10, 20, 30, 40, 50}) {
    OcpGenerator generator(101);
    Row row;
    for (int i = 0; i < kProblems; ++i)
      contest.run(generator.next(horizon, 2), {}, kUnknown, row);
    print_row("horizon " + std::to_string(horizon) + ", 2 obstacles", row);
  }
  for (const int horizon : {10, 20, 30, 40, 50}) {
    OcpGenerator generator(101);
    Row row;
    for (int i = 0; i < kProblems; ++i) {
      const ControlProblem before = generator.next(horizon, 2);
      const MpcSolution answer = contest.answer(before);
      if (answer.status != SolveStatus::Solved) continue;
      contest.run(generator.next_cycle(before, answer), shifted(answer), kUnknown, row);
    }
    print_row("horizon " + std::to_string(horizon) + ", 2 obstacles, next cycle, warm", row);
  }
  for (const int obstacles : {0, 1, 2, 4, 8, 16}) {
    OcpGenerator generator(202);
    Row row;
    for (int i = 0; i < kProblems; ++i)
      contest.run(generator.next(10, obstacles), {}, kUnknown, row);
    print_row("horizon 10, " + std::to_string(obstacles) + " obstacles", row);
  }
}

}  // namespace
}  // namespace fairway::benchmark

int main(int argc, char** argv) {
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 20;
  if (argc > 3 || repeats < 1) {
    std::fprintf(stderr, "usage: solver_benchmark [FOLDER [REPEATS]]\n");
    return 2;
  }
  fairway::benchmark::Contest contest(repeats);
  fairway::benchmark::run_generated(contest);
  if (argc > 1) fairway::benchmark::run_shared(std::string(argv[1]) + "/", contest);
  return 0;
}
