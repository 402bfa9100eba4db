// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/simulation/episode.hpp"

namespace fairway {

/// A run in which robots sense with a lidar, or are moved by another engine than the unicycle.
///
/// `run_episode` comes here for such scenarios; here nobody watches and nobody plays, so
/// `hooks.observer` and `hooks.play` are not used.
[[nodiscard]] EpisodeResult run_sensed_episode(const Scenario& scenario, const EpisodeHooks& hooks);

}  // namespace fairway
