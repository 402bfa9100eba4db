// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Fairway turns a map, or lidar scans, into velocity commands for a wheeled robot.
///
/// MapNavigator drives on a map; MaplessNavigator drives on what a lidar measures; BodyNavigator
/// drives long bodies, cars, tricycles and omnidirectional bases on a map. All are constructed with
/// Settings and called once per control period. The stages can also be used alone: Planner (path
/// and corridor), build_corridor, RealTimeSolver and SafetyMonitor.

#include "fairway/corridor/corridor_builder.hpp"
#include "fairway/monitor/safety_monitor.hpp"
#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/navigation/body/body_navigator.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"
#include "fairway/navigation/facade/mapless_navigator.hpp"
#include "fairway/perception/map_localization.hpp"
#include "fairway/planning/planner.hpp"
