// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "cli/output.hpp"
#include "cli/point_argument.hpp"
#include "cli/provenance.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/planning/path_obstruction.hpp"
#include "fairway/zones/zones.hpp"

namespace fairway::app {

/// The input of `fairway plan`.
struct PlanQuery {
  PointArgument start;
  PointArgument goal;
  Settings settings;
  Zones zones;
  PlannerHooks hooks;
};

/// The answer of `fairway plan`, with the fastest time of each stage.
struct PlanAnswer {
  Plan plan;
  std::string reason;  ///< why there is no plan, with numbers; empty with a plan
  std::optional<PathObstruction> obstruction;  ///< the same as numbers, if there is no path
  double prepare_seconds = 0.0;  ///< computing obstacles and distances of the map's cells [s]
};

/// An obstruction as all results write it.
[[nodiscard]] Json obstruction_json(const PathObstruction& obstruction);

/// The plan as the JSON object of the command-line interface; `method` is the corridor's.
[[nodiscard]] std::string plan_json(const PlanAnswer& answer,
                                    const PlanQuery& query,
                                    const char* method,
                                    const Provenance& provenance);

/// The plan in three lines for the user; empty without a plan.
[[nodiscard]] std::string plan_summary(const PlanAnswer& answer);

/// Draws the plan into a file; does nothing without a file name.
[[nodiscard]] Expected<void> write_plan_picture(const std::string& file,
                                                const OccupancyGrid& grid,
                                                const PlanQuery& query,
                                                const Plan& plan);

}  // namespace fairway::app
