// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/command_line.hpp"

namespace fairway::app {

/// Each adds one command to the tool. A build without serve or reproduce still has these commands;
/// they then print how to get them.
void add_barn_command(CommandLine& tool);
void add_bodies_command(CommandLine& tool);
void add_dynabarn_command(CommandLine& tool);
void add_parking_command(CommandLine& tool);
void add_compare_command(CommandLine& tool);
void add_dynabarn_command(CommandLine& tool);
void add_merge_command(CommandLine& tool);
void add_order_command(CommandLine& tool);
void add_people_command(CommandLine& tool);
void add_plan_command(CommandLine& tool);
/// The commands completion and manual. @pre `tool` outlives its run.
void add_reference_commands(CommandLine& tool);
void add_replay_command(CommandLine& tool);
void add_reproduce_command(CommandLine& tool);
void add_serve_command(CommandLine& tool);
void add_settings_command(CommandLine& tool);
void add_simulate_command(CommandLine& tool);
void add_solve_command(CommandLine& tool);
void add_statuses_command(CommandLine& tool);

}  // namespace fairway::app
