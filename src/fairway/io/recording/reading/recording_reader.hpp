// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/base/error.hpp"
#include "fairway/simulation/episode_observer.hpp"

namespace fairway::io {

/// Tells `observer` everything that a recording holds, in the order in which it happened. The plan
/// of a step is given with what can be shown of it: poses, commands and what limits it. `name` is
/// the file in messages.
[[nodiscard]] Expected<void> read_recording(std::string_view bytes,
                                            const std::string& name,
                                            EpisodeObserver& observer);

/// The same, from a file.
[[nodiscard]] Expected<void> read_recording(const std::string& path, EpisodeObserver& observer);

}  // namespace fairway::io
