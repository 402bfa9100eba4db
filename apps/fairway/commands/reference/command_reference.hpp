// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/command_line.hpp"

namespace fairway::app {

/// Returns a script for bash that completes commands, options and their values. Options without a
/// fixed list of values complete file names. Read it with `source`, or put it into
/// bash-completion's folder.
[[nodiscard]] std::string bash_completion(const std::vector<CommandHelp>& commands);

/// The same for zsh, to be put as `_fairway` into a folder of `fpath`.
[[nodiscard]] std::string zsh_completion(const std::vector<CommandHelp>& commands);

/// The manual page fairway(1) in the man macros of troff.
[[nodiscard]] std::string manual_page(const std::vector<CommandHelp>& commands);

}  // namespace fairway::app
