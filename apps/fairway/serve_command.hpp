// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command.hpp"

namespace fairway::app {

/// `fairway serve [SCENARIO.yaml]`: the live page.
void add_serve_command(CLI::App& tool, Command& chosen);

}  // namespace fairway::app
