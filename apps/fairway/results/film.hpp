// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "fairway/base/error.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/scenario.hpp"

namespace fairway::app {

/// Receives the finished share of a film, from 0 to 1.
using FilmProgress = std::function<void(double share)>;

/// Whether films can be made in this build; the error names the option and what is missing.
[[nodiscard]] Expected<void> check_film();

/// Makes a short film (GIF) of the first robot's run, seen by MuJoCo's camera from behind and
/// above. It has five pictures per second, or about a hundred if the run is longer than 20 s.
[[nodiscard]] Expected<std::string> run_film(const Scenario& scenario,
                                             const EpisodeResult& result,
                                             const FilmProgress& progress);

}  // namespace fairway::app
