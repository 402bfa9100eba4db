// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <vector>

#include <fmt/core.h>

#include "cli/left_out.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/settings_options.hpp"
#include "commands/commands.hpp"
#include "experiments/clocks.hpp"
#include "experiments/paper/case1.hpp"
#include "experiments/paper/case2.hpp"
#include "experiments/paper/case3.hpp"
#include "experiments/paper/report.hpp"
#ifdef FAIRWAY_HAS_IPOPT
#include "fairway/mpc/ipopt/ipopt_solver.hpp"
#endif

namespace fairway::app {

namespace {

using reproduction::Chapter;
using reproduction::StudyOptions;

struct ReproduceCommand {
  std::string which;
  std::string folder;
  std::string solver = "interior_point";
  int seed = 0;
  int maps = 0;
  int threads = 2;
  SettingsOptions settings;

  [[nodiscard]] Expected<int> run() const;
  [[nodiscard]] Expected<StudyOptions> options() const;
};

Expected<StudyOptions> ReproduceCommand::options() const {
  StudyOptions options{.seed = static_cast<std::uint64_t>(seed), .maps = maps, .threads = threads};
  options.clock = thread_cpu_seconds;
  const Expected<Settings> ours = load_settings(settings);
  if (!ours) return tl::unexpected(ours.error());
  if (const auto valid = validate(*ours); !valid) return tl::unexpected(valid.error());
  options.ours = *ours;
  if (solver == "interior_point") return options;
#ifdef FAIRWAY_HAS_IPOPT
  options.make_solver = [] { return std::make_unique<IpoptSolver>(); };
  options.threads = 1;  // MUMPS is not thread-safe
  return options;
#else
  return fail("--solver: expected interior_point, found " + solver + ", " +
              left_out("coinor-libipopt-dev"));
#endif
}

Expected<int> ReproduceCommand::run() const {
  Expected<StudyOptions> options = this->options();
  if (!options) return tl::unexpected(options.error());
  if (const auto made = reproduction::make_report_folder(folder); !made) {
    return tl::unexpected(made.error());
  }
  std::vector<Chapter> chapters;
  {
    Progress progress("reproduce");
    options->progress = [&](const std::string& state) { progress.show(state); };
    if (which == "case1" || which == "all") {
      chapters.push_back(reproduction::run_case1(*options));
    }
    if (which == "case2" || which == "all") {
      chapters.push_back(reproduction::run_case2(*options));
    }
    if (which == "case3" || which == "all") {
      chapters.push_back(reproduction::run_case3(*options));
    }
    options->progress("drawing");
    std::string command = fmt::format("fairway reproduce {} --seed {}", which, seed);
    if (maps > 0) command += fmt::format(" --maps {}", maps);
    if (solver != "interior_point") command += " --solver " + solver;
    for (const std::string& assignment : settings.assignments)
      command += " --set " + assignment;
    if (!settings.file.empty()) command += " --settings " + settings.file;
    if (!settings.preset.empty()) command += " --preset " + settings.preset;
    const reproduction::ReportInfo info{.settings = options->ours,
                                        .command = command + " --out DIR",
                                        .version = tool_version(),
                                        .solver = solver,
                                        .seed = options->seed};
    if (const auto done = reproduction::write_report(folder, chapters, info); !done) {
      return tl::unexpected(done.error());
    }
  }
  if (const auto done = print(reproduction::report_summary(folder, chapters)); !done) {
    return tl::unexpected(done.error());
  }
  for (const Chapter& chapter : chapters) {
    if (chapter.faults.empty()) continue;
    print_error(chapter.faults.front());
    return kFailed;
  }
  return kDone;
}

}  // namespace

void add_reproduce_command(CommandLine& tool) {
  const auto command = std::make_shared<ReproduceCommand>();
  const Options options =
      tool.add_command("reproduce", "Write the paper's tables and figures beside Fairway's",
                       [command] { return command->run(); });
  options.add("CASE", command->which, "Which of the paper's cases")
      .required()
      .one_of({"case1", "case2", "case3", "all"});
  options.add("--out", command->folder, "Folder for pictures, results.json and index.html")
      .required()
      .type_name("DIR");
  options
      .add("--solver", command->solver,
           "Solver of the optimal control problems; ipopt is the paper's")
      .one_of({"interior_point", "ipopt"})
      .shows_default();
  options.add("--seed", command->seed, "Seed of the maps in the figures; others follow from it")
      .between(0, 1000000)
      .shows_default();
  options.add("--maps", command->maps, "Number of maps for the means; 0: the default of each case")
      .between(0, 10000)
      .shows_default();
  options.add("--threads", command->threads, "Number of threads; it does not change the results")
      .between(1, 64)
      .shows_default();
  add_settings_options(options, command->settings);
  options.footer(
      "Settings apply to the runs of Fairway. Exit code 1: a run broke a guarantee, for example by "
      "a contact.");
}

}  // namespace fairway::app
