// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "cli/output.hpp"
#include "cli/point_argument.hpp"
#include "cli/progress.hpp"
#include "cli/provenance.hpp"
#include "cli/settings_options.hpp"
#include "cli/shard_option.hpp"
#include "commands/commands.hpp"
#include "experiments/clocks.hpp"
#include "experiments/people/people_files.hpp"
#include "experiments/people/people_summary.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/simulation/recorded/metrics.hpp"

namespace fairway::app {

namespace {

struct PeopleCommand {
  std::string benchmark;
  std::string folder;
  std::string cases = "all";
  std::string kinematics = "ours";
  std::string shard;
  std::string trace;
  std::string json;
  SettingsOptions settings;

  [[nodiscard]] Expected<int> run() const;
  [[nodiscard]] bool recorded() const { return benchmark == "recorded"; }
  [[nodiscard]] CrowdBenchmark crowd() const {
    if (benchmark == "crowdnav") return CrowdBenchmark::CrowdNav;
    return benchmark == "dsrnn" ? CrowdBenchmark::DsRnn : CrowdBenchmark::CrowdNavPlus;
  }
  [[nodiscard]] Expected<std::vector<int>> numbers() const;
  [[nodiscard]] Expected<PeopleOptions> options() const;
  [[nodiscard]] Expected<void> drive_recorded(const PeopleOptions& options,
                                              PeopleSummary& summary,
                                              std::string& rows) const;
  [[nodiscard]] Expected<void> drive_crowd(const PeopleOptions& options,
                                           PeopleSummary& summary,
                                           std::string& rows) const;
  [[nodiscard]] Json result_json(const PeopleSummary& summary, const Settings& used) const;
};

Expected<std::vector<int>> PeopleCommand::numbers() const {
  std::vector<int> chosen;
  if (cases == "all") return chosen;
  const std::optional<std::vector<double>> list = parse_list(cases);
  for (const double value : list.value_or(std::vector<double>())) {
    if (value != std::floor(value) || value < 0.0 || value > 1e9) break;
    chosen.push_back(static_cast<int>(value));
  }
  if (!list || chosen.size() != list->size() || chosen.empty()) {
    return fail("--cases: expected all, or numbers separated by commas, found " +
                io::excerpt(cases));
  }
  return chosen;
}

Expected<PeopleOptions> PeopleCommand::options() const {
  if (kinematics == "theirs" && benchmark != "dsrnn") {
    return fail(fmt::format(
        "--kinematics: expected ours for {}, whose own robot moves sideways, found theirs",
        benchmark));
  }
  PeopleOptions options;
  options.clock = thread_cpu_seconds;
  options.kinematics = kinematics == "theirs" ? Kinematics::Jumps : Kinematics::Ours;
  if (recorded()) {
    use_recorded_robot(options.settings);
  } else {
    use_crowd_robot(crowd(), options.kinematics, options.settings);
  }
  const Expected<Settings> own = load_settings(settings, options.settings);
  if (!own) return tl::unexpected(own.error());
  if (const auto valid = validate(*own); !valid) return tl::unexpected(valid.error());
  options.settings = *own;
  const double step = recorded() ? PeopleRecording::kFrame : crowd_rules(crowd()).step;
  if (const auto fits = check_period(*own, step); !fits) return tl::unexpected(fits.error());
  if (recorded() && own->navigation.control_period < 0.99 * PeopleRecording::kFrame)
    return fail("navigation.control_period: expected 0.1 for recorded people, found less");
  return options;
}

Expected<void> PeopleCommand::drive_recorded(const PeopleOptions& options,
                                             PeopleSummary& summary,
                                             std::string& rows) const {
  const Expected<std::vector<int>> wanted = numbers();
  if (!wanted) return tl::unexpected(wanted.error());
  const Expected<std::vector<RecordedCase>> all = io::read_recorded_cases(folder, *wanted);
  if (!all) return tl::unexpected(all.error());
  std::map<std::string, PeopleRecording> recordings;
  for (const RecordedCase& task : *all) {
    if (recordings.contains(task.scene)) continue;
    Expected<PeopleRecording> recording = io::read_recording(folder, task.scene);
    if (!recording) return tl::unexpected(recording.error());
    recordings.emplace(task.scene, *std::move(recording));
  }
  const Shard part = parse_shard(shard);
  Progress progress("people");
  std::size_t number = 0;
  for (const RecordedCase& task : *all) {
    if (!part.has(number++)) continue;
    progress.show(fmt::format("case {}: {} of {} done", task.number, summary.runs.size(),
                              all->size() / part.count));
    PeopleRun run = run_recorded(task, recordings.at(task.scene), options);
    if (!trace.empty()) rows += people_rows_csv(run);
    summary.add(std::move(run));
  }
  return {};
}

Expected<void> PeopleCommand::drive_crowd(const PeopleOptions& options,
                                          PeopleSummary& summary,
                                          std::string& rows) const {
  const Expected<std::vector<int>> wanted = numbers();
  if (!wanted) return tl::unexpected(wanted.error());
  const Expected<std::vector<CrowdCase>> all = io::read_crowd_cases(folder, crowd(), *wanted);
  if (!all) return tl::unexpected(all.error());
  const Shard part = parse_shard(shard);
  Progress progress("people");
  std::size_t number = 0;
  for (const CrowdCase& one : *all) {
    if (!part.has(number++)) continue;
    progress.show(fmt::format("case {}: {} of {} done", one.number, summary.runs.size(),
                              all->size() / part.count));
    PeopleRun run = run_crowd(crowd(), one, options);
    if (!trace.empty()) rows += people_rows_csv(run);
    summary.add(std::move(run));
  }
  return {};
}

Json PeopleCommand::result_json(const PeopleSummary& summary, const Settings& used) const {
  Json rows = Json::array();
  for (const PeopleRun& run : summary.runs) {
    rows.push_back({{"case", run.number},
                    {"outcome", to_text(run.outcome)},
                    {"time", run.time},
                    {"path", run.path},
                    {"closest", run.closest},
                    {"steps", run.steps},
                    {"danger", run.steps > 0 ? static_cast<double>(run.danger) / run.steps : 0.0},
                    {"contact_between_steps", run.contact_between_steps}});
  }
  const Quantiles cycle = quantiles(summary.cycle_seconds);
  return {{"cases", std::move(rows)},
          {"benchmark", benchmark},
          {"success_rate", summary.share(PeopleOutcome::Success)},
          {"contact_rate", summary.share(PeopleOutcome::Contact)},
          {"timeout_rate", summary.share(PeopleOutcome::Timeout)},
          {"mean_time", summary.mean_time()},
          {"mean_path", summary.mean_path()},
          {"mean_closest", summary.mean_closest()},
          {"danger_rate", summary.danger_rate()},
          {"contact_between_steps_rate", summary.contact_between_steps_rate()},
          {"cycle_us",
           {{"median", 1e6 * cycle.median}, {"p99", 1e6 * cycle.p99}, {"max", 1e6 * cycle.max}}},
          {"kinematics", kinematics},
          {"robot",
           {{"linear_max", used.robot.linear_max},
            {"linear_min", used.robot.linear_min},
            {"angular_max", used.robot.angular_max},
            {"linear_acceleration_max", used.robot.linear_acceleration_max},
            {"angular_acceleration_max", used.robot.angular_acceleration_max},
            {"control_period", used.navigation.control_period}}}};
}

Expected<int> PeopleCommand::run() const {
  for (const std::string& file : {json, trace}) {
    if (const auto checked = check_output(file); !checked) return tl::unexpected(checked.error());
  }
  note_input_folder(folder, [](std::string_view name) {
    return name.starts_with("tracks_") || name == "cases.csv" || name.ends_with("_cases.csv");
  });
  if (const auto apart = check_apart({{"--json", json}, {"--trace", trace}}); !apart)
    return tl::unexpected(apart.error());
  const Expected<PeopleOptions> used = options();
  if (!used) return tl::unexpected(used.error());
  PeopleSummary summary;
  std::string rows = "case,time,x,y,heading\n";
  const auto driven =
      recorded() ? drive_recorded(*used, summary, rows) : drive_crowd(*used, summary, rows);
  if (!driven) return tl::unexpected(driven.error());
  if (!trace.empty()) {
    if (const auto done = write_output(trace, rows); !done) return tl::unexpected(done.error());
  }
  if (!json.empty()) {
    Json result = result_json(summary, used->settings);
    if (!shard.empty()) result["shard"] = shard;
    add_provenance(
        result,
        {.schema = "people.v1", .files = {folder, settings.file}, .settings = &used->settings});
    if (const auto done = write_output(json, json_text(result)); !done)
      return tl::unexpected(done.error());
  }
  const std::size_t successes = summary.count(PeopleOutcome::Success);
  if (json != "-" && trace != "-") {
    std::string text;
    for (const PeopleRun& run : summary.runs) {
      if (run.outcome == PeopleOutcome::Success) continue;
      text +=
          fmt::format("case {}: {} after {:.2f} s\n", run.number, to_text(run.outcome), run.time);
    }
    const Quantiles cycle = quantiles(summary.cycle_seconds);
    text += fmt::format(
        "{} of {} cases: success {:.3f}, contact {:.3f}, timeout {:.3f}; successes: {:.2f} s, "
        "{:.2f} m, closest {:.3f} m; danger {:.2f} %, contact between steps {:.3f}, cycle "
        "{:.0f}/{:.0f} us median/p99\n",
        successes, summary.runs.size(), summary.share(PeopleOutcome::Success),
        summary.share(PeopleOutcome::Contact), summary.share(PeopleOutcome::Timeout),
        summary.mean_time(), summary.mean_path(), summary.mean_closest(),
        100.0 * summary.danger_rate(), summary.contact_between_steps_rate(), 1e6 * cycle.median,
        1e6 * cycle.p99);
    if (const auto done = print(text); !done) return tl::unexpected(done.error());
  }
  return successes == summary.runs.size() ? kDone : kFailed;
}

}  // namespace

void add_people_command(CommandLine& tool) {
  const auto command = std::make_shared<PeopleCommand>();
  const Options options = tool.add_command("people", "Drive among people: four public benchmarks",
                                           [command] { return command->run(); });
  options
      .add("BENCHMARK", command->benchmark, "Recorded people, or a benchmark with simulated ones")
      .required()
      .one_of({"recorded", "crowdnav", "dsrnn", "crowdnavpp"});
  options.add("DIR", command->folder, "Folder with cases and tracks").required();
  options.add("--cases", command->cases, "all, or numbers separated by commas");
  options
      .add("--kinematics", command->kinematics,
           "ours: a unicycle with limited accelerations; theirs: that of the benchmark")
      .one_of({"ours", "theirs"});
  add_shard_option(options, command->shard);
  options.add("--trace", command->trace, "Write all runs as CSV: case,time,x,y,heading")
      .type_name("FILE");
  options.add("--json", command->json, "Write the result as JSON; - is standard output")
      .type_name("FILE");
  add_settings_options(options, command->settings);
  options.footer(
      "The robot of recorded is a disc that touches a person at 0.5 m, with 1.75 m/s; "
      "docs/people.md has the limits of all.");
}

}  // namespace fairway::app
