// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fairway/io/recording/run_messages.hpp"
#include "fairway/simulation/interactive/running_episode.hpp"
#include "fairway/simulation/recorded/observer_list.hpp"
#include "server/live_world.hpp"

namespace fairway::app {

/// A LiveWorld in a program without threads: the caller advances it when the next cycle is due.
class SteppedWorld {
 public:
  SteppedWorld(std::vector<MapChoice> choices, LiveListener listener)
      : world_(std::move(choices), std::move(listener), LiveWorld::Begin::Stepped) {}

  /// For requests; `advance` serves them.
  [[nodiscard]] LiveWorld& world() noexcept { return world_; }

  /// Serves all requests, and computes the next control cycle if it is due.
  /// @return the time until the next cycle is due [s]; infinity while the world is paused.
  double advance();

 private:
  // A run and what observes it; both use `scenario`.
  struct Run {
    explicit Run(LiveWorld& world);
    Scenario scenario;
    io::RunMessages recorded;
    ObserverList observers;
    std::optional<Episode> episode;
  };

  void begin();
  void compute_cycle();
  // Serves the requests; true when the next cycle follows at once.
  bool serve();
  [[nodiscard]] double wait() const;

  LiveWorld world_;
  std::unique_ptr<Run> run_;
  bool stuck_ = false;  // no run can begin; a request begins again
};

}  // namespace fairway::app
