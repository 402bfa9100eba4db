// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/command_line.hpp"

namespace fairway::app {

/// "which this build left out; to get it: ...", with the commands that build all of the tool.
/// @param packages  Debian packages that the part needs, with spaces between them.
[[nodiscard]] std::string left_out(const char* packages);

/// Adds a command that this build left out: whatever its arguments, it tells how to get it.
void add_left_out_command(CommandLine& tool,
                          const char* name,
                          const char* help,
                          const char* packages);

}  // namespace fairway::app
