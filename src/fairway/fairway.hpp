// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Fairway: from a map, or a lidar, to velocity commands for a wheeled robot.
///
/// MapNavigator drives on a map, MaplessNavigator on what a lidar sees; both are constructed with
/// Settings and called once per control period. The stages can be used alone: Planner (path and
/// corridor), build_corridor, RealTimeSolver.

#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"
#include "fairway/navigation/facade/mapless_navigator.hpp"
#include "fairway/planning/planner.hpp"
