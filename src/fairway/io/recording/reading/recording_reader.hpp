// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/base/error.hpp"
#include "fairway/simulation/episode_observer.hpp"

namespace fairway::io {

/// Passes all events of a recording to `observer`, in the order in which they happened. The plan of
/// a step has only its displayed part: poses, commands and the limiting constraint. `name` is the
/// file in messages.
[[nodiscard]] Expected<void> read_recording(std::string_view bytes,
                                            const std::string& name,
                                            EpisodeObserver& observer);

/// Does the same with a file.
[[nodiscard]] Expected<void> read_recording(const std::string& path, EpisodeObserver& observer);

}  // namespace fairway::io
