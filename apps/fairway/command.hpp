// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <string>

#include <CLI/CLI.hpp>

#include "fairway/base/error.hpp"

namespace fairway::app {

/// Exit codes of the tool: what scripts rely on.
inline constexpr int kDone = 0;      ///< the task was carried out
inline constexpr int kFailed = 1;    ///< the task is sound but has no answer
inline constexpr int kBadInput = 2;  ///< bad usage or bad input; an Error tells which

/// A command that was chosen on the command line: gives an exit code, or the error behind
/// kBadInput.
using Command = std::function<Expected<int>()>;

/// Each adds one command to the tool; parsing the command line then puts its work into `chosen`.
void add_barn_command(CLI::App& tool, Command& chosen);
void add_dynabarn_command(CLI::App& tool, Command& chosen);
void add_plan_command(CLI::App& tool, Command& chosen);
void add_settings_command(CLI::App& tool, Command& chosen);
void add_solve_command(CLI::App& tool, Command& chosen);
void add_simulate_command(CLI::App& tool, Command& chosen);

/// Whether a first argument is neither an option nor a command. (CLI11 then tells of a missing
/// command, not of the wrong one.)
[[nodiscard]] inline bool names_no_command(const CLI::App& tool, const std::string& word) {
  if (word.starts_with('-')) return false;
  const auto commands = tool.get_subcommands([](const CLI::App* /*command*/) { return true; });
  return std::none_of(commands.begin(), commands.end(),
                      [&](const CLI::App* command) { return command->check_name(word); });
}

}  // namespace fairway::app
