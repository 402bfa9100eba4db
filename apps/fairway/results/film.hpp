// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "fairway/base/error.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/scenario.hpp"

namespace fairway::app {

/// Told how much of a film is drawn, from 0 to 1.
using FilmProgress = std::function<void(double share)>;

/// Whether films can be made here at all; if not, which option was in vain and what is missing.
[[nodiscard]] Expected<void> check_film();

/// The bytes of a short film (GIF) of the first robot's run, seen by MuJoCo's camera from behind
/// and above: five pictures a second, about a hundred of a run that is longer than 20 s.
[[nodiscard]] Expected<std::string> run_film(const Scenario& scenario,
                                             const EpisodeResult& result,
                                             const FilmProgress& progress);

}  // namespace fairway::app
