// SPDX-License-Identifier: Apache-2.0
#include "cli/left_out.hpp"
#include "commands/commands.hpp"

namespace fairway::app {

void add_serve_command(CommandLine& tool) {
  add_left_out_command(tool, "serve", "Serve a page with an interactive world", "libboost-dev");
}

}  // namespace fairway::app
