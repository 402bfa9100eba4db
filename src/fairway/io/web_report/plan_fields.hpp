// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "fairway/io/web_report/compact_fields.hpp"
#include "fairway/planning/path_obstruction.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway::io {

/// Why a plan is not usable: a sentence for users, and the obstruction if there is one.
struct PlanExplanation {
  std::string text;
  std::optional<PathObstruction> obstruction;
};

/// Explains plans that are not usable, and remembers the last explanation. While a robot has no
/// path, the same plan fails again and again.
class PlanExplainer {
 public:
  /// Maps with more cells are not searched, because the search takes time of the world [cells].
  static constexpr std::int64_t kMostCells = 4'000'000;

  [[nodiscard]] const PlanExplanation& explain(const BitGrid& obstacles,
                                               const Eigen::Vector2d& start,
                                               const Plan& plan,
                                               double radius);

 private:
  struct Question {
    Eigen::Vector2d start = Eigen::Vector2d::Zero();
    Eigen::Vector2d goal = Eigen::Vector2d::Zero();
    PathStatus path = PathStatus::Found;
    CorridorStatus corridor = CorridorStatus::Built;
    double radius = 0.0;
    double margin = 0.0;
    std::size_t cells = 0;  // hash of the obstacles

    friend bool operator==(const Question&, const Question&) = default;
  };

  std::optional<Question> question_;
  PlanExplanation answer_;
};

/// Whether this is the plan of a robot whose goal was dropped.
[[nodiscard]] bool is_dropped(const Plan& plan) noexcept;

/// Goal with flags (1 usable, 2 heading, 4 no goal), path and corridor.
void append_plan(CompactFields& out, const Plan& plan);

/// The sentence; then 0, or 1 + kind, position, found and needed.
void append_obstruction(CompactFields& out, const Plan& plan, const PlanExplanation& why);

/// Flags (1 collided, 2 absent); after a collision with what, which, when and both speeds.
void append_encounter(CompactFields& out, const Encounter& met);

}  // namespace fairway::io
