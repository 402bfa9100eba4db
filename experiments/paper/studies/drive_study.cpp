// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/studies/drive_study.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "experiments/paper/studies/parallel_runs.hpp"
#include "fairway/base/contract.hpp"
#include "fairway/simulation/scenarios/generated_maps.hpp"

namespace fairway::reproduction {

namespace {

constexpr double kDriverRadius = 0.25;     // [m]
constexpr double kDriveCorner = 1.5;       // start and goal are this far from the corners [m]
constexpr double kDriveTimeLimit = 120.0;  // more than twice what a run takes [s]

}  // namespace

const char* to_text(DriverKind kind) noexcept {
  switch (kind) {
    case DriverKind::Smpc:
      return "SMPC [17]";
    case DriverKind::Ismpc:
      return "ISMPC (the paper's)";
    case DriverKind::Ours:
      return "Fairway";
  }
  return "unknown";
}

const char* to_text(DriveCourse course) noexcept {
  switch (course) {
    case DriveCourse::Structured:
      return "structured";
    case DriveCourse::Unstructured:
      return "unstructured";
    case DriveCourse::LargeRectangles:
      return "structured, large rectangles";
  }
  return "unknown";
}

MapKind map_kind(DriveCourse course) noexcept {
  return course == DriveCourse::Unstructured ? MapKind::UnstructuredSmall : MapKind::Structured;
}

Settings driver_settings(DriveCourse course, DriverKind kind, const Settings& ours) {
  constexpr double kNever = 1000.0;  // [s]
  Settings settings = kind == DriverKind::Ours ? ours : paper_settings();
  settings.robot.radius = kDriverRadius;
  if (kind == DriverKind::Ours) return settings;
  settings.navigation.stall_timeout = kNever;
  if (course == DriveCourse::LargeRectangles) settings.corridor.method = CorridorMethod::Fewest;
  if (kind == DriverKind::Smpc) settings.tracking.target_mode = TargetMode::OverlapCentroid;
  return settings;
}

bool DriveComparison::all_reached() const {
  return std::all_of(drives.begin(), drives.end(), [](const Drive& d) { return d.reached; });
}

Scenario drive_scenario(DriveCourse course,
                        std::uint64_t seed,
                        DriverKind kind,
                        const Settings& ours) {
  const double far = side_length(map_kind(course)) - kDriveCorner;
  Scenario scenario;
  scenario.name = to_text(kind);
  scenario.map = generate_map(map_kind(course), seed);
  scenario.settings = driver_settings(course, kind, ours);
  scenario.robots = {
      {.name = "robot",
       .start = {.position = {kDriveCorner, kDriveCorner}, .heading = 0.25 * std::numbers::pi},
       .goal = {.position = {far, far}, .heading = std::nullopt}}};
  scenario.time_limit = kDriveTimeLimit;
  return scenario;
}

Drive drive(const Scenario& scenario, const StudyOptions& options) {
  const std::unique_ptr<ControlSolver> solver =
      options.make_solver ? options.make_solver() : nullptr;
  EpisodeResult result = run_episode(scenario, {.clock = options.clock, .solver = solver.get()});
  const RobotResult& robot = result.robots.front();
  Drive drive{
      .robot = scenario.settings.robot,
      .reached = robot.reached,
      .collided = robot.collided,
      .time = robot.time,
      .length = robot.length,
      .smoothness = smoothness(result.trace, 0),
      .switches = rectangle_switches(result.trace, 0),
      .stop_cycles = robot.status_counts[static_cast<std::size_t>(NavigationStatus::Stopping)],
      .min_clearance = robot.min_clearance,
      .solve = quantiles(robot.solve_seconds),
      .plan = robot.plan};
  const double dt = scenario.settings.navigation.control_period;
  Twist2 last;
  for (const TraceRow& row : result.trace.rows) {
    Twist2& change = drive.greatest_change;
    change.linear = std::max(change.linear, std::abs(row.command.linear - last.linear) / dt);
    change.angular = std::max(change.angular, std::abs(row.command.angular - last.angular) / dt);
    last = row.command;
    for (const Twist2& twist : {row.command, row.twist}) {
      drive.least.linear = std::min(drive.least.linear, twist.linear);
      drive.least.angular = std::min(drive.least.angular, twist.angular);
      drive.greatest.linear = std::max(drive.greatest.linear, twist.linear);
      drive.greatest.angular = std::max(drive.greatest.angular, twist.angular);
    }
  }
  drive.rows = std::move(result.trace.rows);
  return drive;
}

std::vector<DriveComparison> compare_drivers(DriveCourse course,
                                             int maps,
                                             const StudyOptions& options) {
  constexpr std::size_t kMostTries = 50;  // per requested map; most maps have a path
  const auto wanted = static_cast<std::size_t>(maps);
  std::vector<DriveComparison> all;
  for (std::size_t tried = 0; all.size() < wanted && tried < kMostTries * wanted;) {
    const std::size_t batch = wanted - all.size();
    std::vector<DriveComparison> more =
        run_all(batch, options, std::string("drives, ") + to_text(course), [&](std::size_t i) {
          DriveComparison one{.seed = map_seed(options, tried + i), .possible = true};
          for (std::size_t k = 0; k < kDriverKinds && one.possible; ++k) {
            const Scenario scenario =
                drive_scenario(course, one.seed, static_cast<DriverKind>(k), options.ours);
            one.drives.at(k) = drive(scenario, options);
            one.possible = one.drives.at(k).plan.usable();
          }
          return one;
        });
    tried += batch;
    for (DriveComparison& one : more) {
      if (one.possible) all.push_back(std::move(one));
    }
  }
  FAIRWAY_ENSURES(!all.empty());
  return all;
}

}  // namespace fairway::reproduction
