// SPDX-License-Identifier: Apache-2.0
#include "cli/left_out.hpp"
#include "commands/commands.hpp"

namespace fairway::app {

void add_reproduce_command(CommandLine& tool) {
  add_left_out_command(tool, "reproduce", "Write the paper's tables and figures beside Fairway's",
                       "libboost-dev");
}

}  // namespace fairway::app
