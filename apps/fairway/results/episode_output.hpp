// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/output.hpp"
#include "fairway/base/error.hpp"
#include "fairway/simulation/episode.hpp"

namespace fairway::app {

/// The result as INTERFACE.md's JSON object. An infinite distance is null.
[[nodiscard]] Json episode_json(const Scenario& scenario, const EpisodeResult& result);

/// The result as a short table for a person.
[[nodiscard]] std::string episode_table(const EpisodeResult& result);

/// In one line, which robot failed first and why: where it is, what its plan lacks, and its last
/// status. @pre the run was no success.
[[nodiscard]] std::string failure_text(const Scenario& scenario, const EpisodeResult& result);

/// The bytes of the pictures of a run, in the format that the name ends in.
[[nodiscard]] Expected<std::string> world_picture(const Scenario& scenario,
                                                  const EpisodeResult& result,
                                                  const std::string& file);
[[nodiscard]] Expected<std::string> speed_picture(const Scenario& scenario,
                                                  const EpisodeResult& result,
                                                  const std::string& file);

}  // namespace fairway::app
