// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "cli/output.hpp"
#include "cli/provenance.hpp"
#include "commands/commands.hpp"
#include "fairway/io/recording/reading/recording_reader.hpp"
#include "fairway/io/recording/recording.hpp"
#include "fairway/io/web_report/report.hpp"
#include "fairway/simulation/recorded/observer_list.hpp"
#include "fairway/simulation/recorded/replay_check.hpp"

namespace fairway::app {

namespace {

struct ReplayCommand {
  std::string recording;
  std::string json;
  std::string report;

  [[nodiscard]] Expected<int> run() const;
};

std::string answer_text(const NavigationStep& step) {
  return fmt::format("{} m/s, {} rad/s, {} ({})", step.command.linear, step.command.angular,
                     to_text(step.status), to_text(step.limit));
}

Json answer_json(const NavigationStep& step) {
  return {{"linear", step.command.linear},
          {"angular", step.command.angular},
          {"status", to_text(step.status)},
          {"limit", to_text(step.limit)}};
}

std::string table(const ReplayCheck& check) {
  if (!check.first_difference()) {
    return fmt::format("{} control cycles, every command the same to the bit\n", check.cycles());
  }
  const ReplayCheck::Difference& first = *check.first_difference();
  return fmt::format(
      "{} of {} control cycles differ, the first at {} s, robot {}:\n"
      "  recorded  {}\n  replayed  {}\n",
      check.different(), check.cycles(), first.time, first.robot, answer_text(first.recorded),
      answer_text(first.replayed));
}

Json result(const ReplayCheck& check) {
  Json json{{"cycles", check.cycles()}, {"different", check.different()}};
  if (const auto& first = check.first_difference()) {
    json["first_difference"] = {{"time", first->time},
                                {"robot", first->robot},
                                {"recorded", answer_json(first->recorded)},
                                {"replayed", answer_json(first->replayed)}};
  }
  return json;
}

Expected<int> ReplayCommand::run() const {
  for (const auto& possible : {check_output(json), check_output(report)}) {
    if (!possible) return tl::unexpected(possible.error());
  }
  note_input(recording);
  if (const auto apart = check_apart({{"--json", json}, {"--report", report}}); !apart)
    return tl::unexpected(apart.error());
  ReplayCheck check;
  io::Report page;
  ObserverList observers;
  observers.add(check);
  if (!report.empty()) observers.add(page.observer());
  if (const auto read = io::read_recording(recording, observers); !read) {
    return tl::unexpected(read.error());
  }
  if (!report.empty()) {
    if (const auto done = write_output(report, page.page()); !done) {
      return tl::unexpected(done.error());
    }
  }
  if (!json.empty()) {
    Json written = result(check);
    add_provenance(written, {.schema = "replay.v1", .files = {recording}});
    if (const auto done = write_output(json, json_text(written)); !done)
      return tl::unexpected(done.error());
  }
  if (json != "-") {
    if (const auto done = print(table(check)); !done) return tl::unexpected(done.error());
  }
  return check.different() == 0 ? kDone : kFailed;
}

}  // namespace

void add_replay_command(CommandLine& tool) {
  const auto command = std::make_shared<ReplayCommand>();
  const Options options = tool.add_command(
      "replay", "Run the navigators of a recording again and compare their commands",
      [command] { return command->run(); });
  options.add("FILE", command->recording, "Recording made by --log")
      .required()
      .type_name("FILE.mcap");
  options.add("--json", command->json, "Write the result as JSON; - is standard output")
      .type_name("FILE");
  options.add("--report", command->report, "Write a page that plays the recorded run")
      .type_name("FILE.html");
}

}  // namespace fairway::app
