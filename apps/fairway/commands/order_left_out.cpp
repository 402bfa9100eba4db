// SPDX-License-Identifier: Apache-2.0
#include "cli/left_out.hpp"
#include "commands/commands.hpp"

namespace fairway::app {

void add_order_command(CommandLine& tool) {
  add_left_out_command(tool, "order", "Send an order to a vehicle of VDA 5050 and follow it",
                       "libmosquitto-dev");
}

}  // namespace fairway::app
