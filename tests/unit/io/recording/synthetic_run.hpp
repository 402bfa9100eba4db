// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/simulation/episode_observer.hpp"

namespace fairway::test {

/// A synthetic run in which every field has content. Robots drive on a circle, bodies cross it,
/// plans change, cells appear, and one robot has a separate map.
struct SyntheticRun {
  int robots = 2;
  int bodies = 2;
  double seconds = 5.0;
  int map_side = 120;        ///< [cells]
  bool rectangular = false;  ///< the robots' bodies

  [[nodiscard]] Scenario scenario() const;

  /// Passes the whole run to an observer.
  void play(EpisodeObserver& observer) const;
};

}  // namespace fairway::test
