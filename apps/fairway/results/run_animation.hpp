// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/simulation/episode.hpp"

namespace fairway::app {

/// Collects where robots and moving obstacles are during a run, and draws an animation of it.
class RunAnimation final : public EpisodeObserver {
 public:
  void on_start(const Scenario& /*scenario*/) override { moments_.clear(); }
  void on_navigators(double /*time*/,
                     const Settings& /*settings*/,
                     std::span<const NavigatorStart> /*starts*/) override {}
  void on_plan(double /*time*/, std::size_t /*robot*/, const Plan& /*plan*/) override {}
  void on_cycle(const NavigationCycle& /*cycle*/) override {}
  void on_world(const WorldView& world) override;

  /// The bytes of an SVG file that plays the run in a loop, in at most 12 s.
  [[nodiscard]] Expected<std::string> draw(const Scenario& scenario,
                                           const EpisodeResult& result) const;

 private:
  struct Moment {
    double time = 0.0;
    std::vector<std::optional<Pose2>> robots;  // none: absent
    std::vector<MovingObstacle> bodies;
  };
  std::vector<Moment> moments_;
};

}  // namespace fairway::app
