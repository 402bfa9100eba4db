// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/base/error.hpp"
#include "fairway/simulation/episode.hpp"

namespace fairway::app {

/// The result as INTERFACE.md's JSON object, as text. An infinite distance is null.
[[nodiscard]] std::string episode_json(const EpisodeResult& result);

/// The result as a short table for a person.
[[nodiscard]] std::string episode_table(const EpisodeResult& result);

/// In one line, which robot failed first and why. @pre the run was no success.
[[nodiscard]] std::string failure_text(const EpisodeResult& result);

/// The bytes of the pictures of a run, in the format that the name ends in.
[[nodiscard]] Expected<std::string> world_picture(const Scenario& scenario,
                                                  const EpisodeResult& result,
                                                  const std::string& file);
[[nodiscard]] Expected<std::string> speed_picture(const Scenario& scenario,
                                                  const EpisodeResult& result,
                                                  const std::string& file);

}  // namespace fairway::app
