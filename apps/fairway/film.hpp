// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/error.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/scenario.hpp"

namespace fairway::app {

/// Whether films can be made here at all; if not, which option was in vain and what is missing.
[[nodiscard]] Expected<void> check_film();

/// The bytes of a short film (GIF) of the first robot's run, seen by MuJoCo's camera from behind
/// and above.
[[nodiscard]] Expected<std::string> run_film(const Scenario& scenario, const EpisodeResult& result);

}  // namespace fairway::app
