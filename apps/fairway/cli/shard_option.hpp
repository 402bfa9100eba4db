// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "cli/command_line.hpp"

namespace fairway::app {

/// Part `index` of `count` parts of a batch. It holds every count-th run, so that long and short
/// runs spread evenly.
struct Shard {
  std::size_t index = 1;  ///< 1 to count
  std::size_t count = 1;

  /// Whether run number `run` of the batch, from 0 on, belongs to this part.
  [[nodiscard]] bool has(std::size_t run) const noexcept { return run % count == index - 1; }
};

/// Adds --shard I/N to a command; `text` is what was given, empty for all runs.
void add_shard_option(const Options& options, std::string& text);

/// Returns the shard that `text` denotes. @pre the option accepted it.
[[nodiscard]] Shard parse_shard(const std::string& text);

}  // namespace fairway::app
