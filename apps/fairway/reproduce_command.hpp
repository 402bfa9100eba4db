// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command.hpp"

namespace fairway::app {

/// `fairway reproduce`: the paper's tables and figures beside ours.
void add_reproduce_command(CLI::App& tool, Command& chosen);

}  // namespace fairway::app
