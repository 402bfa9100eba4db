// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/simulation/lidar_senses.hpp"
#include "fairway/simulation/world.hpp"
#ifdef FAIRWAY_WITH_GUARD
#include "bridge/command_guard.hpp"
#endif

namespace fairway::campaign {

#ifdef FAIRWAY_WITH_GUARD

/// The safety monitor as the nodes run it, behind the navigator, on a lidar of its own.
class Guard {
 public:
  Guard(const Scenario& scenario, const World& world, std::uint64_t seed)
      : senses_(scenario.sensing, world, 0, seed) {
    const BodyRobot* const model = world.model_of(0);
    if (model == nullptr) {
      guard_.emplace(bridge::monitor_settings(scenario.settings));
    } else if (model->model.base.kind == BaseKind::Unicycle) {
      guard_.emplace(bridge::monitor_settings(scenario.settings, model->model));
    }
  }

  /// @return what remains of the command.
  [[nodiscard]] Twist2 check(const World& world, const Twist2& command) {
    if (!guard_) return command;
    senses_.measure(world);
    senses_.deliver(world.time(),
                    [&](const LidarScan& scan, const Eigen::Vector2d&) { guard_->observe(scan); });
    const MonitorVerdict verdict = guard_->check(world.time(), senses_.pose(), sent_, command);
    sent_ = verdict.command;
    if (verdict.reason != MonitorReason::None) ++reduced;
    return sent_;
  }

  int reduced = 0;  ///< commands

 private:
  LidarSenses senses_;
  std::optional<bridge::CommandGuard> guard_;
  Twist2 sent_;
};

#else

class Guard {
 public:
  Guard(const Scenario&, const World&, std::uint64_t) {}
  [[nodiscard]] Twist2 check(const World&, const Twist2& command) const { return command; }
  int reduced = 0;
};

#endif

}  // namespace fairway::campaign
