// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/simulation/episode_observer.hpp"

namespace fairway::test {

/// A run that nobody drove, put together so that every field has something in it: robots go round
/// on a circle, bodies cross it, plans change, cells appear, and one robot sees a world of its own.
struct SyntheticRun {
  int robots = 2;
  int bodies = 2;
  double seconds = 5.0;
  int map_side = 120;        ///< [cells]
  bool rectangular = false;  ///< the robots' bodies

  [[nodiscard]] Scenario scenario() const;

  /// Tells all of it to an observer.
  void play(EpisodeObserver& observer) const;
};

}  // namespace fairway::test
