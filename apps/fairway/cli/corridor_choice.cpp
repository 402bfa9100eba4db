// SPDX-License-Identifier: Apache-2.0
#include "cli/corridor_choice.hpp"

#include <fmt/core.h>

#include "experiments/baselines/sound_baselines.hpp"
#include "fairway/io/number_text.hpp"

namespace fairway::app {

Expected<CorridorChoice> choose_corridor(const std::string& name, CorridorSettings& settings) {
  if (name == "mdsrc") settings.method = CorridorMethod::Mdsrc;
  if (name == "fewest") settings.method = CorridorMethod::Fewest;
  if (name.empty() || name == "mdsrc" || name == "fewest") {
    const bool fewest = settings.method == CorridorMethod::Fewest;
    return CorridorChoice{.name = fewest ? "fewest" : "mdsrc", .build = build_corridor};
  }
  if (name == "src") return CorridorChoice{.name = "src", .build = baselines::build_src};
  if (name == "fsrc") return CorridorChoice{.name = "fsrc", .build = baselines::build_fsrc};
  return fail(
      fmt::format("--corridor: expected src, fsrc, mdsrc or fewest, found {}", io::excerpt(name)));
}

}  // namespace fairway::app
