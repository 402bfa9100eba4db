// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/provenance.hpp"
#include "cli/settings_options.hpp"
#include "commands/commands.hpp"
#include "experiments/clocks.hpp"
#include "experiments/solver/ocp_instances.hpp"
#include "experiments/solver/paper_problem.hpp"
#include "fairway/mpc/evaluation.hpp"
#include "results/instance_solver.hpp"
#include "results/solve_report.hpp"

namespace fairway::app {

namespace {

using io::OcpInstance;
using io::OcpResult;

// The guess for instance `index`: the result at this index if it has the same id. Otherwise it is
// the first result with this id, or a cold start.
InitialGuess guess_for(std::size_t index, int id, const std::vector<OcpResult>& results) {
  InitialGuess guess;
  auto found = results.end();
  if (index < results.size() && results[index].id == id) {
    found = results.begin() + static_cast<std::ptrdiff_t>(index);
  } else {
    found = std::find_if(results.begin(), results.end(),
                         [id](const OcpResult& result) { return result.id == id; });
  }
  if (found == results.end()) return guess;
  guess.count = io::kOcpHorizon;
  std::copy(found->commands.begin(), found->commands.end(), guess.commands.begin());
  return guess;
}

// Checks a solver's commands independently: rolls them out and evaluates the constraints again.
SolveStatus checked_status(const ControlProblem& problem, const MpcSolution& solution) {
  if (solution.status != SolveStatus::Solved) return solution.status;
  MpcSolution again;
  again.commands = solution.commands;
  assess(problem, again);
  const double worst = std::max(again.max_violation, bound_violation(problem, again.commands).max);
  return worst <= kFeasibilityTolerance ? SolveStatus::Solved : SolveStatus::Stalled;
}

struct SolveCommand {
  std::string instances_file;
  std::string out;
  std::string solver = "interior_point";
  std::string warm_file;
  int starts = 0;  // 0: as many as the solver takes by default
  int repeat = 1;
  std::string json;
  SettingsOptions settings;

  [[nodiscard]] Expected<int> run();
  [[nodiscard]] Expected<Settings> load() const;
  [[nodiscard]] SolvedInstance solve_one(InstanceSolver& solve,
                                         const ControlProblem& problem,
                                         const OcpInstance& instance,
                                         const InitialGuess& first) const;
};

SolvedInstance SolveCommand::solve_one(InstanceSolver& solve,
                                       const ControlProblem& problem,
                                       const OcpInstance& instance,
                                       const InitialGuess& first) const {
  std::vector<InitialGuess> guesses(static_cast<std::size_t>(starts));
  spread_guesses(problem, first, guesses);
  SolvedInstance solved{.id = instance.id, .kind = instance.kind};
  solved.time_us = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeat; ++i) {
    const double begin = thread_cpu_seconds();
    const MpcSolution& solution = solve.solve(problem, guesses);
    solved.time_us = std::min(solved.time_us, 1e6 * (thread_cpu_seconds() - begin));
    if (i == 0) solved.solution = solution;
  }
  solved.solution.status = checked_status(problem, solved.solution);
  return solved;
}

OcpResult as_result(const SolvedInstance& solved) {
  OcpResult result{.id = solved.id,
                   .status = static_cast<int>(solved.solution.status),
                   .iterations = solved.solution.iterations,
                   .time_us = solved.time_us,
                   .commands = {}};
  result.commands.assign(solved.solution.commands.begin(),
                         solved.solution.commands.begin() + io::kOcpHorizon);
  return result;
}

// The instances' own weights and limits, and what the options change in them.
Expected<Settings> SolveCommand::load() const {
  Settings own = paper_settings();
  own.mpc = paper_mpc_settings();
  own.robot = paper_robot_settings();
  Expected<Settings> loaded = load_settings(settings, own);
  if (loaded && loaded->mpc.horizon != io::kOcpHorizon) {
    return fail(fmt::format("mpc.horizon: expected {}, the horizon of the result file, found {}",
                            io::kOcpHorizon, loaded->mpc.horizon));
  }
  return loaded;
}

Expected<int> SolveCommand::run() {
  if (starts == 0) starts = solver == "interior_point" ? 4 : 1;
  if (out.empty()) return fail("--out: expected a file name, found an empty one");
  note_input(instances_file);
  note_input(warm_file);
  if (const auto apart = check_apart({{"--out", out}, {"--json", json}}); !apart)
    return tl::unexpected(apart.error());
  const Expected<Settings> chosen = load();
  if (!chosen) return tl::unexpected(chosen.error());
  const auto instances = io::read_ocp_instances(instances_file);
  if (!instances) return tl::unexpected(instances.error());
  std::vector<OcpResult> warm;
  if (!warm_file.empty()) {
    auto results = io::read_ocp_results(warm_file);
    if (!results) return tl::unexpected(results.error());
    warm = std::move(*results);
  }
  for (const std::string& file : {out, json}) {
    if (const auto writable = check_output(file); !writable)
      return tl::unexpected(writable.error());
  }
  const auto solve = make_instance_solver(solver);
  if (!solve) return tl::unexpected(solve.error());

  std::vector<SolvedInstance> solved;
  std::vector<OcpResult> results;
  {
    Progress progress("solving");
    for (std::size_t i = 0; i < instances->size(); ++i) {
      const OcpInstance& instance = (*instances)[i];
      const ControlProblem problem = io::control_problem(instance, chosen->mpc, chosen->robot);
      solved.push_back(solve_one(**solve, problem, instance, guess_for(i, instance.id, warm)));
      results.push_back(as_result(solved.back()));
      progress.show(fmt::format("{} of {}", i + 1, instances->size()));
    }
  }
  if (const auto written = write_output(out, io::format_ocp_results(results)); !written)
    return tl::unexpected(written.error());
  Json report = solve_report(solver, starts, repeat, solved);
  add_provenance(report, {.schema = "solve.v1",
                          .files = {instances_file, warm_file, settings.file},
                          .settings = &*chosen});
  if (const auto written = write_output(json, json_text(report)); !written)
    return tl::unexpected(written.error());
  if (out == "-" || json == "-") return kDone;
  if (const auto printed = print(solve_table(solved)); !printed)
    return tl::unexpected(printed.error());
  return kDone;
}

}  // namespace

void add_solve_command(CommandLine& tool) {
  const auto command = std::make_shared<SolveCommand>();
  const Options options = tool.add_command(
      "solve", "Solve instances of the optimal control problem (Eq. 15) and write the commands",
      [command] { return command->run(); });
  options
      .add("INSTANCES", command->instances_file,
           "File with one instance per line: id class nobs pose targets rectangle obstacles")
      .required();
  options.add("--out", command->out, "Result file: id status iterations time_us u0 r0 ...")
      .required();
  options.add("--solver", command->solver, "interior_point or ipopt")
      .shows_default()
      .one_of({"interior_point", "ipopt"});
  options.add("--warm", command->warm_file, "Result file with commands for a warm start");
  options
      .add("--starts", command->starts,
           "Number of starts per instance; the best result is kept (default: 4, for ipopt 1)")
      .between(1, 1000);
  options.add("--repeat", command->repeat, "Number of repeats; the fastest time is written")
      .shows_default()
      .between(1, 1000000);
  options.add("--json", command->json, "Write a report as JSON; - is standard output")
      .type_name("FILE");
  add_settings_options(options, command->settings);
  options.footer(
      "Settings of the groups mpc and robot change the weights and limits of all instances; "
      "without any the problem is the paper's.");
}

}  // namespace fairway::app
