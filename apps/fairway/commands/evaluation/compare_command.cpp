// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <memory>

#include <nlohmann/json.hpp>

#include "cli/json_file.hpp"
#include "cli/number_option.hpp"
#include "cli/provenance.hpp"
#include "commands/commands.hpp"
#include "results/json_comparison.hpp"

namespace fairway::app {

namespace {

struct CompareCommand {
  std::string a;
  std::string b;
  std::optional<double> tolerance;
  bool timings = false;
  bool all = false;
  std::string json;

  [[nodiscard]] Expected<int> run() const {
    if (const auto checked = check_output(json); !checked) return tl::unexpected(checked.error());
    for (const std::string& file : {a, b})
      note_input(file);
    if (const auto apart = check_apart({{"--json", json}}); !apart)
      return tl::unexpected(apart.error());
    const Expected<Json> first = read_json_object(a);
    if (!first) return tl::unexpected(first.error());
    const Expected<Json> second = read_json_object(b);
    if (!second) return tl::unexpected(second.error());
    const JsonComparison comparison = compare_json(*first, *second, tolerance.value_or(0.0));
    if (!json.empty()) {
      Json result = comparison_json(comparison);
      add_provenance(result, {.schema = "compare.v1", .files = {a, b}});
      if (const auto done = write_output(json, json_text(result)); !done)
        return tl::unexpected(done.error());
    }
    if (json != "-") {
      constexpr std::size_t kLines = 50;
      const std::size_t limit = all ? std::numeric_limits<std::size_t>::max() : kLines;
      if (const auto done = print(comparison_text(comparison, timings, limit)); !done)
        return tl::unexpected(done.error());
    }
    return comparison.count(ValueKind::Result) == 0 ? kDone : kFailed;
  }
};

}  // namespace

void add_compare_command(CommandLine& tool) {
  const auto command = std::make_shared<CompareCommand>();
  const Options options =
      tool.add_command("compare", "Print what differs between two results, and by how much",
                       [command] { return command->run(); });
  options.add("A", command->a, "Result of a command's --json").required().type_name("A.json");
  options.add("B", command->b, "Another one").required().type_name("B.json");
  options
      .add("--tolerance", command->tolerance,
           "Relative difference up to which numbers count as equal")
      .check(number_between(0.0, 1.0));
  options.add_flag("--timings", command->timings, "Print computing times that differ too");
  options.add_flag("--all", command->all, "Print every difference, not the first 50");
  options.add("--json", command->json, "Write the differences as JSON; - is standard output")
      .type_name("FILE");
  options.footer(
      "Exit code 1: results differ. Computing times and provenance (version, command line, inputs, "
      "settings) do not count.");
}

}  // namespace fairway::app
