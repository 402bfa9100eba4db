// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "cli/output.hpp"
#include "cli/physics_choice.hpp"
#include "cli/point_argument.hpp"
#include "cli/progress.hpp"
#include "cli/provenance.hpp"
#include "cli/settings_options.hpp"
#include "cli/shard_option.hpp"
#include "commands/commands.hpp"
#include "experiments/barn/barn_file.hpp"
#include "experiments/barn/barn_summary.hpp"
#include "experiments/clocks.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/io/scenario/robot_model_file.hpp"
#include "fairway/io/trace_file.hpp"
#include "fairway/simulation/recorded/metrics.hpp"
#include "results/barn_output.hpp"
#include "results/episode_output.hpp"
#include "results/film.hpp"
#include "results/run_outputs.hpp"

namespace fairway::app {

namespace {

using ReadWorlds = Expected<std::vector<BarnWorld>> (*)(const std::string&,
                                                        const std::vector<int>&);

struct BarnCommand {
  ReadWorlds read = nullptr;
  std::string source;
  std::string worlds = "all";
  std::string sensing = "map";
  std::string pose = "exact";
  std::string physics = "unicycle";
  std::string noise = "none";
  std::string body;
  int seed = 1;
  int trials = 1;
  std::string trace_dir;
  std::string film_dir;
  std::string shard;
  std::string json;
  SettingsOptions settings;
  RunOutputs outputs;

  [[nodiscard]] Expected<int> run();
  [[nodiscard]] Expected<std::vector<int>> numbers() const;
  [[nodiscard]] Expected<BarnOptions> options() const;
  [[nodiscard]] Expected<BarnScore> drive(const BarnWorld& world,
                                          int trial,
                                          const Scenario& scenario,
                                          const PhysicsMaker& engine,
                                          bool only_run,
                                          BarnSummary& summary);
  [[nodiscard]] Expected<void> keep_trace(const std::string& run,
                                          const Scenario& scenario,
                                          const BarnScore& score,
                                          const EpisodeResult& result);
  [[nodiscard]] Expected<void> make_folders() const;
};

Expected<std::vector<int>> BarnCommand::numbers() const {
  if (worlds == "all") return std::vector<int>();
  const std::optional<std::vector<double>> list = parse_list(worlds);
  std::vector<int> chosen;
  for (const double value : list.value_or(std::vector<double>())) {
    if (value != std::floor(value) || value < 0.0 || value > 1e6) break;
    chosen.push_back(static_cast<int>(value));
  }
  if (!list || chosen.size() != list->size() || chosen.empty()) {
    return fail("--worlds: expected all, or numbers separated by commas, found " +
                io::excerpt(worlds));
  }
  return chosen;
}

Expected<BarnOptions> BarnCommand::options() const {
  BarnOptions options;
  use_jackal(options.settings);
  const Expected<Settings> own = load_settings(settings, options.settings);
  if (!own) return tl::unexpected(own.error());
  if (const auto valid = validate(*own); !valid) return tl::unexpected(valid.error());
  options.settings = *own;
  options.sensing.sensing = sensing == "lidar" ? Sensing::Lidar : Sensing::Map;
  options.sensing.pose = pose == "scans" ? PoseSource::Scans : PoseSource::Exact;
  if (pose == "scans" && sensing == "lidar")
    return fail("--pose: expected exact with --sensing lidar, found scans");
  if (noise == "standard") use_standard_noise(options.sensing);
  if (!body.empty()) {
    const Expected<RobotModel> model = io::read_robot_model(body);
    if (!model) return tl::unexpected(model.error());
    options.model = *model;
    note_input(body);
    if (physics != "unicycle") return fail("--body: expected --physics unicycle, found " + physics);
  }
  options.seed = static_cast<std::uint64_t>(seed);
  return options;
}

// Writes the trace of every trial, a picture and a page of each failed one, and films if requested.
Expected<void> BarnCommand::keep_trace(const std::string& run,
                                       const Scenario& scenario,
                                       const BarnScore& score,
                                       const EpisodeResult& result) {
  if (!film_dir.empty()) {
    Progress progress("film");
    const Expected<std::string> film = run_film(scenario, result, [&](double share) {
      progress.show(fmt::format("{}: {:.0f} % drawn", run, 100.0 * share));
    });
    if (!film) return tl::unexpected(film.error());
    if (auto done = write_output(film_dir + "/" + run + ".gif", *film); !done) return done;
  }
  if (trace_dir.empty()) return {};
  const std::string name = trace_dir + "/" + run;
  if (auto done = write_output(name + ".csv", io::trace_csv(result)); !done) return done;
  if (score.success) return {};
  const Expected<std::string> bytes = world_picture(scenario, result, name + ".svg");
  if (!bytes) return tl::unexpected(bytes.error());
  if (auto done = write_output(name + ".svg", *bytes); !done) return done;
  return write_output(name + ".html", outputs.page());
}

Expected<BarnScore> BarnCommand::drive(const BarnWorld& world,
                                       int trial,
                                       const Scenario& scenario,
                                       const PhysicsMaker& engine,
                                       bool only_run,
                                       BarnSummary& summary) {
  const std::string run = fmt::format("world_{:03}_trial_{}", world.number, trial);
  if (!trace_dir.empty()) outputs.keep_page();
  if (const auto opened = outputs.open(only_run ? "" : run); !opened)
    return tl::unexpected(opened.error());
  const EpisodeResult result = run_episode(scenario, {.clock = thread_cpu_seconds,
                                                      .on_cycle = {},
                                                      .physics = engine,
                                                      .solver = nullptr,
                                                      .observer = outputs.observer(),
                                                      .play = {}});
  const BarnScore score = barn_score(world, trial, result);
  summary.add(score, result);
  if (const auto kept = keep_trace(run, scenario, score, result); !kept)
    return tl::unexpected(kept.error());
  if (const auto closed = outputs.close(); !closed) return tl::unexpected(closed.error());
  return score;
}

Expected<void> BarnCommand::make_folders() const {
  if (!film_dir.empty()) {
    if (auto can = check_film(); !can) return can;
  }
  for (const auto& [option, folder] :
       {std::pair("--trace-dir", &trace_dir), std::pair("--film-dir", &film_dir)}) {
    if (folder->empty()) continue;
    std::error_code failed;
    std::filesystem::create_directories(*folder, failed);
    if (failed) {
      return fail(fmt::format("{}: expected a folder that can be made, found {}", option,
                              io::excerpt(*folder)));
    }
  }
  return {};
}

Expected<int> BarnCommand::run() {
  if (const auto checked = check_output(json); !checked) return tl::unexpected(checked.error());
  const Expected<std::vector<int>> wanted = numbers();
  if (!wanted) return tl::unexpected(wanted.error());
  const Expected<BarnOptions> shared = options();
  if (!shared) return tl::unexpected(shared.error());
  const Expected<PhysicsMaker> engine = choose_physics(physics);
  if (!engine) return tl::unexpected(engine.error());
  const Expected<std::vector<BarnWorld>> all = read(source, *wanted);
  if (!all) return tl::unexpected(all.error());
  note_input(source);
  note_input(source + "/barn.json");
  for (const char* part : {"/circles", "/maps"})
    note_input_folder(source + part, [](std::string_view) { return true; });
  if (const auto apart =
          check_apart({{"--json", json}, {"--log", outputs.log}, {"--report", outputs.report}});
      !apart) {
    return tl::unexpected(apart.error());
  }
  if (const auto made = make_folders(); !made) return tl::unexpected(made.error());

  BarnSummary summary;
  Progress progress("barn");
  std::string failures;
  const Shard part = parse_shard(shard);
  std::size_t number = 0;
  for (const BarnWorld& world : *all) {
    for (int trial = 0; trial < trials; ++trial) {
      if (!part.has(number++)) continue;
      progress.show(fmt::format("world {}, trial {}: {} of {} runs done", world.number, trial,
                                summary.trials.size(),
                                all->size() * static_cast<std::size_t>(trials) / part.count));
      const Scenario scenario = barn_scenario(world, *shared, trial);
      const bool only_run = all->size() == 1 && trials == 1;
      const Expected<BarnScore> score = drive(world, trial, scenario, *engine, only_run, summary);
      if (!score) return tl::unexpected(score.error());
      if (!score->success) {
        failures += fmt::format("world {}, trial {}: {} after {:.1f} s\n", world.number, trial,
                                score->collided ? "contact" : "goal not reached", score->time);
      }
    }
  }
  if (!json.empty()) {
    Json result = barn_json(summary, {.sensing = sensing, .physics = physics, .noise = noise});
    if (!shard.empty()) result["shard"] = shard;
    add_provenance(result, {.schema = "barn.v1",
                            .files = {source, settings.file},
                            .seed = shared->seed,
                            .settings = &shared->settings});
    if (const auto done = write_output(json, json_text(result)); !done) {
      return tl::unexpected(done.error());
    }
  }
  if (json != "-") {
    const std::string text = failures + barn_text(summary);
    if (const auto done = print(text); !done) return tl::unexpected(done.error());
  }
  return failures.empty() ? kDone : kFailed;
}

void add_command(
    CommandLine& tool, const char* name, const char* help, const char* source, ReadWorlds read) {
  const auto command = std::make_shared<BarnCommand>();
  command->read = read;
  const Options options = tool.add_command(name, help, [command] { return command->run(); });
  options.add("SOURCE", command->source, source).required();
  options.add("--worlds", command->worlds, "all, or numbers separated by commas");
  options.add("--sensing", command->sensing, "What the robot knows").one_of({"map", "lidar"});
  options.add("--pose", command->pose, "How a robot that knows the map knows its pose")
      .one_of({"exact", "scans"});
  options.add("--physics", command->physics, "Model that moves the robot")
      .one_of({"unicycle", "mujoco"});
  options.add("--noise", command->noise, "Errors of lidar and odometry")
      .one_of({"none", "standard"});
  options
      .add("--body", command->body,
           "Drive with this outline and base, as under `robot:` of a scenario's robot")
      .type_name("FILE.yaml");
  options.add("--seed", command->seed, "Seed of all random numbers").not_negative();
  options.add("--trials", command->trials, "Runs per world").between(1, 1000);
  add_shard_option(options, command->shard);
  options.add("--trace-dir", command->trace_dir,
              "Write the cycles of every run here, and a picture and a page of every failed one");
  options.add("--film-dir", command->film_dir,
              "Write a short film (GIF) of every run here, drawn by MuJoCo");
  options.add("--json", command->json, "Write the result as JSON; - is standard output")
      .type_name("FILE");
  add_run_options(options, command->outputs);
  add_settings_options(options, command->settings);
  options.footer(std::string("These are ") + kBarnNote + ".");
}

}  // namespace

void add_barn_command(CommandLine& tool) {
  add_command(tool, "barn", "Drive through the worlds of BARN",
              "Folder with barn.json and its maps", io::read_barn);
}

void add_dynabarn_command(CommandLine& tool) {
  add_command(tool, "dynabarn", "Drive through the worlds of DynaBARN", "File like dynabarn.json",
              io::read_dynabarn);
}

}  // namespace fairway::app
