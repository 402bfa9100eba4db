// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "cli/point_argument.hpp"
#include "cli/provenance.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/planning/path_obstruction.hpp"

namespace fairway::app {

/// What `fairway plan` was asked.
struct PlanQuery {
  PointArgument start;
  PointArgument goal;
  Settings settings;
  PlannerHooks hooks;
};

/// What it found, with the fastest time of each stage.
struct PlanAnswer {
  Plan plan;
  std::string reason;  ///< why there is none, with numbers; empty where there is one
  std::optional<PathObstruction> obstruction;  ///< the same as numbers, where a path is missing
  double prepare_seconds = 0.0;  ///< making obstacles and distances of the map's cells [s]
};

/// The plan as INTERFACE.md's JSON object, as text; `method` is the corridor's.
[[nodiscard]] std::string plan_json(const PlanAnswer& answer,
                                    const PlanQuery& query,
                                    const char* method,
                                    const Provenance& provenance);

/// The plan in three lines for a person; empty when there is none.
[[nodiscard]] std::string plan_summary(const PlanAnswer& answer);

/// Draws the plan into a file; nothing without a name.
[[nodiscard]] Expected<void> write_plan_picture(const std::string& file,
                                                const OccupancyGrid& grid,
                                                const PlanQuery& query,
                                                const Plan& plan);

}  // namespace fairway::app
