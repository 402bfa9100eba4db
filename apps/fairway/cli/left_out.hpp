// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/command_line.hpp"

namespace fairway::app {

/// The text "which this build left out; to get it: ...", with the commands that build the whole
/// tool.
/// @param packages  Debian packages that the part needs, separated by spaces.
[[nodiscard]] std::string left_out(const char* packages);

/// Adds a command that this build left out; with any arguments, it prints how to get it.
void add_left_out_command(CommandLine& tool,
                          const char* name,
                          const char* help,
                          const char* packages);

}  // namespace fairway::app
