// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

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
void add_simulate_command(CLI::App& tool, Command& chosen);

}  // namespace fairway::app
