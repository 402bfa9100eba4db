// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string_view>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "cli/output.hpp"
#include "cli/provenance.hpp"
#include "commands/commands.hpp"
#include "fairway/navigation/explanation/status_guide.hpp"
#include "fairway/navigation/explanation/status_label.hpp"

namespace fairway::app {

namespace {

// Calls visit(text, label, guide) for every value of an enumeration that begins with 0.
template <typename Enumeration, typename Visit>
void for_each(std::size_t count, Visit&& visit) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = static_cast<Enumeration>(i);
    visit(to_text(value), label_of(value), guide_of(value));
  }
}

template <typename Visit>
void for_each_status(Visit&& visit) {
  for_each<NavigationStatus>(kNavigationStatuses, visit);
}

template <typename Visit>
void for_each_limit(Visit&& visit) {
  for_each<LimitingFactor>(kLimitingFactors, visit);
}

std::string markdown() {
  std::string text;
  const auto row = [&](const char* name, const char* label, const StatusGuide& guide) {
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", name, label, guide.meaning, guide.causes,
                        guide.remedy);
  };
  const auto head = [&](const char* what) {
    text += fmt::format(
        "| {} | on the pages | meaning | usual causes | what to do |\n|---|---|---|---|---|\n",
        what);
  };
  head("status");
  for_each_status(row);
  text += '\n';
  head("limiting factor");
  for_each_limit(row);
  return text;
}

std::string as_json() {
  Json statuses = Json::array();
  Json limits = Json::array();
  const auto add_to = [](Json& list) {
    return [&list](const char* name, const char* label, const StatusGuide& guide) {
      list.push_back({{"name", name},
                      {"label", label},
                      {"meaning", guide.meaning},
                      {"causes", guide.causes},
                      {"remedy", guide.remedy}});
    };
  };
  for_each_status(add_to(statuses));
  for_each_limit(add_to(limits));
  Json result{{"statuses", std::move(statuses)}, {"limiting_factors", std::move(limits)}};
  add_provenance(result, {.schema = "statuses.v1", .files = {}});
  return json_text(result);
}

struct StatusesCommand {
  std::string name;
  std::string json;
  bool markdown = false;

  [[nodiscard]] Expected<std::string> text() const;
  [[nodiscard]] Expected<int> run() const {
    if (!json.empty()) {
      if (const auto done = write_output(json, as_json()); !done)
        return tl::unexpected(done.error());
      return kDone;
    }
    const Expected<std::string> shown = text();
    if (!shown) return tl::unexpected(shown.error());
    if (const auto done = print(*shown); !done) return tl::unexpected(done.error());
    return kDone;
  }
};

Expected<std::string> StatusesCommand::text() const {
  if (markdown) return app::markdown();
  std::string found;
  std::string names;
  const auto show = [&](const char* one, const char* label, const StatusGuide& guide) {
    names += fmt::format("  {:<26}{}\n", one, guide.meaning);
    if (name == one || name == label) {
      found = fmt::format("{} ({})\n  meaning: {}\n  causes:  {}\n  remedy:  {}\n", one, label,
                          guide.meaning, guide.causes,
                          *guide.remedy == '\0' ? "none is needed" : guide.remedy);
    }
  };
  names += "statuses\n";
  for_each_status(show);
  names += "limiting factors\n";
  for_each_limit(show);
  if (name.empty()) return names;
  if (found.empty()) {
    return fail(fmt::format(
        "NAME: expected a status or limiting factor, see fairway statuses; found {}", name));
  }
  return found;
}

}  // namespace

void add_statuses_command(CommandLine& tool) {
  const auto command = std::make_shared<StatusesCommand>();
  const Options options =
      tool.add_command("statuses", "Explain statuses and limiting factors: meaning, causes, remedy",
                       [command] { return command->run(); });
  options.add("NAME", command->name, "One of them, as traces and results have it; else all");
  options.add("--json", command->json, "Write all of them as JSON; - is standard output")
      .type_name("FILE");
  options.add_flag("--markdown", command->markdown, "Print the tables of docs/statuses.md instead");
}

}  // namespace fairway::app
