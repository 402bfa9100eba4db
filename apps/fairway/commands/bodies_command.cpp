// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string_view>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "cli/output.hpp"
#include "cli/physics_choice.hpp"
#include "cli/progress.hpp"
#include "cli/provenance.hpp"
#include "cli/shard_option.hpp"
#include "commands/commands.hpp"
#include "experiments/bodies/body_drive.hpp"
#include "experiments/clocks.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/simulation/recorded/metrics.hpp"

namespace fairway::app {

namespace {

using ReadTasks = Expected<std::vector<BodyTask>> (*)(const std::string&,
                                                      const std::vector<std::string>&);

struct BodiesCommand {
  ReadTasks read = nullptr;
  bool parking = false;
  std::string source;
  std::string tasks = "all";
  std::string physics = "unicycle";
  std::string shard;
  std::string trace_dir;
  std::string json;

  [[nodiscard]] Expected<int> run() const;
  [[nodiscard]] Expected<void> check_outputs_apart(const std::vector<BodyTask>& all) const;
};

std::vector<std::string> names_of(const std::string& list) {
  std::vector<std::string> names;
  if (list == "all") return names;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t comma = std::min(list.find(',', begin), list.size());
    names.push_back(list.substr(begin, comma - begin));
    begin = comma + 1;
  }
  return names;
}

Json drive_json(const BodyDrive& drive, bool parking) {
  const Quantiles cycle = quantiles(drive.cycle_seconds);
  Json row{{"task", drive.task},
           {"success", drive.success},
           {"collided", drive.collided},
           {"time", drive.time},
           {"length", drive.length},
           {"cusps", drive.cusps},
           {"min_clearance", drive.min_clearance},
           {"end_distance", drive.end_distance},
           {"end_turn", drive.end_turn},
           {"plan_ms", 1e3 * drive.plan_seconds},
           {"cycle_us",
            {{"median", 1e6 * cycle.median}, {"p99", 1e6 * cycle.p99}, {"max", 1e6 * cycle.max}}},
           {"reason", drive.reason}};
  if (parking) {
    row["gear_changes"] = drive.cusps;
    row["cost"] = drive.cost;
  }
  return row;
}

// A result or a trace must not replace a task, a map or a parking case.
Expected<void> BodiesCommand::check_outputs_apart(const std::vector<BodyTask>& all) const {
  const auto ends = [](std::string_view name, std::initializer_list<const char*> endings) {
    return std::any_of(endings.begin(), endings.end(),
                       [&](const char* ending) { return name.ends_with(ending); });
  };
  std::error_code none;
  const bool whole = std::filesystem::is_directory(source, none);
  const std::string folder =
      whole ? source : std::filesystem::absolute(source, none).parent_path().string();
  note_input(source);
  note_input_folder(folder, [&](std::string_view name) {
    if (parking) return whole && name.ends_with(".csv");
    return ends(name, {".yaml", ".pgm", ".png"}) || (whole && name.ends_with(".json"));
  });
  std::vector<NamedOutput> outputs{{"--json", json}};
  for (const BodyTask& task : all) {
    if (!trace_dir.empty())
      outputs.push_back({"--trace-dir", trace_dir + "/" + task.name + ".csv"});
  }
  return check_apart(outputs);
}

Expected<int> BodiesCommand::run() const {
  const Expected<BodyPlantMaker> plant = choose_body_plant(physics);
  if (!plant) return tl::unexpected(plant.error());
  if (const auto checked = check_output(json); !checked) return tl::unexpected(checked.error());
  const Expected<std::vector<BodyTask>> all = read(source, names_of(tasks));
  if (!all) return tl::unexpected(all.error());
  if (const auto apart = check_outputs_apart(*all); !apart) return tl::unexpected(apart.error());
  if (!trace_dir.empty()) {
    std::error_code failed;
    std::filesystem::create_directories(trace_dir, failed);
    if (failed)
      return fail("--trace-dir: expected a folder that can be made, found " +
                  io::excerpt(trace_dir));
  }
  DriveSettings settings;
  if (parking) {  // the car is three times as long as the bodies are
    settings.path.cell = 0.15;
    settings.path.margin = 0.05;
    settings.alternatives = 1;
    settings.cost = {.linear_effort = 0.1, .turn_effort = 0.03, .steering_angle = 0.1};
  }
  Json rows = Json::array();
  std::string text;
  std::size_t successes = 0;
  Progress progress(parking ? "parking" : "bodies");
  const Shard part = parse_shard(shard);
  std::size_t number = 0;
  for (const BodyTask& task : *all) {
    if (!part.has(number++)) continue;
    progress.show(fmt::format("{}: {} of {} done", task.name, rows.size(), all->size()));
    const BodyDrive drive = drive_task(task, settings, thread_cpu_seconds, *plant);
    if (drive.success) ++successes;
    rows.push_back(drive_json(drive, parking));
    text += fmt::format(
        "{:18} {:6.2f} s {:6.2f} m {:2} cusps {:.3f} m clearance, planned in {:6.0f} ms{}: {}\n",
        drive.task, drive.time, drive.length, drive.cusps, drive.min_clearance,
        1e3 * drive.plan_seconds,
        parking ? fmt::format(", cost {:.0f}", drive.cost) : std::string(), drive.reason);
    if (trace_dir.empty() || drive.rows.empty()) continue;
    const std::string file = trace_dir + "/" + drive.task + ".csv";
    if (const auto done = write_output(file, drive_csv(task, drive)); !done)
      return tl::unexpected(done.error());
  }
  const double rate =
      rows.empty() ? 1.0 : static_cast<double>(successes) / static_cast<double>(rows.size());
  const std::size_t driven = rows.size();
  if (!json.empty()) {
    Json summary{{"tasks", std::move(rows)}, {"success_rate", rate}, {"physics", physics}};
    if (!shard.empty()) summary["shard"] = shard;
    const Settings defaults;
    add_provenance(summary, {.schema = "bodies.v1", .files = {source}, .settings = &defaults});
    if (const auto done = write_output(json, json_text(summary)); !done)
      return tl::unexpected(done.error());
  }
  if (json != "-") {
    text += fmt::format("{} of {} tasks succeeded\n", successes, driven);
    if (const auto done = print(text); !done) return tl::unexpected(done.error());
  }
  return successes == driven ? kDone : kFailed;
}

void add(
    CommandLine& tool, const char* name, const char* help, const char* source, BodiesCommand made) {
  const auto command = std::make_shared<BodiesCommand>(std::move(made));
  const Options options = tool.add_command(name, help, [command] { return command->run(); });
  options.add("SOURCE", command->source, source).required();
  options.add("--tasks", command->tasks, "all, or names with commas between them");
  options
      .add("--physics", command->physics,
           "Model that moves the robot: the kinematics of its base, or MuJoCo")
      .one_of({"unicycle", "mujoco"});
  add_shard_option(options, command->shard);
  options.add("--trace-dir", command->trace_dir, "Write the rows of every drive here, as NAME.csv");
  options.add("--json", command->json, "Write the result as JSON; - is standard output")
      .type_name("FILE");
}

}  // namespace

void add_bodies_command(CommandLine& tool) {
  add(tool, "bodies", "Drive bodies of any shape on any base from pose to pose",
      "Folder with tasks NAME.json and their maps, or one such file",
      {.read = io::read_body_tasks, .parking = false});
}

void add_parking_command(CommandLine& tool) {
  add(tool, "parking", "Park a car in the cases of the TPCAP competition",
      "Folder with cases NAME.csv", {.read = io::read_parking_cases, .parking = true});
}

}  // namespace fairway::app
