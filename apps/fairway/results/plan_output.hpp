// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/point_argument.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/planning/planner.hpp"

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
  double prepare_seconds = 0.0;  ///< making obstacles and distances of the map's cells [s]
};

/// The plan as INTERFACE.md's JSON object, as text; `method` is the corridor's.
[[nodiscard]] std::string plan_json(const PlanAnswer& answer,
                                    const PlanQuery& query,
                                    const char* method);

/// The plan in three lines for a person; empty when there is none.
[[nodiscard]] std::string plan_summary(const PlanAnswer& answer);

/// Draws the plan into a file; nothing without a name.
[[nodiscard]] Expected<void> write_plan_picture(const std::string& file,
                                                const OccupancyGrid& grid,
                                                const PlanQuery& query,
                                                const Plan& plan);

}  // namespace fairway::app
