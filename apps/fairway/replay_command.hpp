// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command.hpp"

namespace fairway::app {

/// `fairway replay FILE.mcap`: runs the navigators of a recording over its inputs again. kDone when
/// every command came out the same to the bit, else kFailed.
void add_replay_command(CLI::App& tool, Command& chosen);

}  // namespace fairway::app
