// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/output.hpp"
#include "fairway/base/error.hpp"
#include "fairway/simulation/episode.hpp"

namespace fairway::app {

/// The result as the JSON object of the command-line interface. An infinite distance is null.
[[nodiscard]] Json episode_json(const Scenario& scenario, const EpisodeResult& result);

/// The result as a short table for the user.
[[nodiscard]] std::string episode_table(const EpisodeResult& result);

/// Describes in one line which robot failed first and why. The line has its position, the reason
/// why there is no plan, or its last status. @pre the run was not successful.
[[nodiscard]] std::string failure_text(const Scenario& scenario, const EpisodeResult& result);

/// The pictures of a run, in the format that the file name's suffix selects.
[[nodiscard]] Expected<std::string> world_picture(const Scenario& scenario,
                                                  const EpisodeResult& result,
                                                  const std::string& file);
[[nodiscard]] Expected<std::string> speed_picture(const Scenario& scenario,
                                                  const EpisodeResult& result,
                                                  const std::string& file);

}  // namespace fairway::app
