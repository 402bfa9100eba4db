// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "cli/json_file.hpp"
#include "commands/commands.hpp"
#include "results/merged_results.hpp"

namespace fairway::app {

namespace {

struct MergeCommand {
  std::vector<std::string> files;
  std::string json = "-";

  [[nodiscard]] Expected<int> run() const {
    if (const auto checked = check_output(json); !checked) return tl::unexpected(checked.error());
    for (const std::string& file : files)
      note_input(file);
    if (const auto apart = check_apart({{"--json", json}}); !apart)
      return tl::unexpected(apart.error());
    std::vector<ShardResult> shards;
    for (const std::string& file : files) {
      Expected<Json> result = read_json_object(file);
      if (!result) return tl::unexpected(result.error());
      shards.push_back({file, std::move(*result)});
    }
    Expected<Json> merged = merge_results(shards);
    if (!merged) return tl::unexpected(merged.error());
    const auto from = merged->find("provenance");
    if (from != merged->end() && from->is_object()) (*from)["command"] = given_command_line();
    if (const auto done = write_output(json, json_text(*merged)); !done)
      return tl::unexpected(done.error());
    return kDone;
  }
};

}  // namespace

void add_merge_command(CommandLine& tool) {
  const auto command = std::make_shared<MergeCommand>();
  const Options options = tool.add_command("merge", "Join the results of the shards of a batch",
                                           [command] { return command->run(); });
  options.add("FILES", command->files, "Results of --json, one per shard")
      .required()
      .type_name("FILE.json...");
  options.add("--json", command->json, "Where to write the joined result; - is standard output")
      .type_name("FILE")
      .shows_default();
}

}  // namespace fairway::app
