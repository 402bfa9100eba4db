// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.hpp"

namespace fairway::app {

/// Each adds one command to the tool. Of those that a build may leave out, serve and reproduce, the
/// command is then there all the same, and says how to get it.
void add_barn_command(CommandLine& tool);
void add_bodies_command(CommandLine& tool);
void add_dynabarn_command(CommandLine& tool);
void add_parking_command(CommandLine& tool);
void add_plan_command(CommandLine& tool);
void add_replay_command(CommandLine& tool);
void add_reproduce_command(CommandLine& tool);
void add_serve_command(CommandLine& tool);
void add_settings_command(CommandLine& tool);
void add_simulate_command(CommandLine& tool);
void add_solve_command(CommandLine& tool);

}  // namespace fairway::app
