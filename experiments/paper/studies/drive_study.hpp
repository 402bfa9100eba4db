// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "experiments/paper/studies/study_options.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/recorded/metrics.hpp"
#include "fairway/simulation/scenarios/generated_maps.hpp"

namespace fairway::reproduction {

/// The drivers of Case 1.
enum class DriverKind : std::uint8_t {
  Smpc,   ///< SMPC [17]: one target, the centroid of the next overlap
  Ismpc,  ///< the paper's: two targets, the next two seeds
  Ours,   ///< our default settings
};
inline constexpr std::size_t kDriverKinds = 3;

[[nodiscard]] const char* to_text(DriverKind kind) noexcept;

/// The courses of Case 1.
enum class DriveCourse : std::uint8_t {
  Structured,       ///< structured, obstacle-dense: the paper's Case 1
  Unstructured,     ///< Environment 2 of Case 2
  LargeRectangles,  ///< structured, with our fewest, largest rectangles for all three
};
inline constexpr std::size_t kDriveCourses = 3;

[[nodiscard]] const char* to_text(DriveCourse course) noexcept;
[[nodiscard]] MapKind map_kind(DriveCourse course) noexcept;

/// Settings of a driver. The body is a disc of 0.25 m, so that the paper's Delta_s = 0.3 m leaves
/// clearance for the error of its Euler step. Our recovery is off for the paper's two methods,
/// which have none. Our stop check is on, because it can only brake.
///
/// @param ours  Settings of DriverKind::Ours, apart from the body.
[[nodiscard]] Settings driver_settings(DriveCourse course,
                                       DriverKind kind,
                                       const Settings& ours = {});

/// One run from corner to corner.
struct Drive {
  RobotSettings robot;  ///< of its settings
  bool reached = false;
  bool collided = false;
  double time = 0.0;           ///< when it stopped at the goal, or the limit [s]
  double length = 0.0;         ///< of the driven path [m]
  double smoothness = 0.0;     ///< integral of the squared rates of change of both speeds
  int switches = 0;            ///< changes of the current rectangle
  int stop_cycles = 0;         ///< in which the stop check overruled the solver
  double min_clearance = 0.0;  ///< from the body to obstacles [m]
  Twist2 least;                ///< commanded or driven
  Twist2 greatest;
  Twist2 greatest_change;  ///< of the command from one cycle to the next, per second
  Quantiles solve;         ///< per cycle [s]
  Plan plan;
  std::vector<TraceRow> rows;
};

/// One map with all drivers.
struct DriveComparison {
  std::uint64_t seed = 0;
  bool possible = false;  ///< whether there is a path; otherwise nothing else is filled
  std::array<Drive, kDriverKinds> drives;

  [[nodiscard]] const Drive& of(DriverKind kind) const {
    return drives.at(static_cast<std::size_t>(kind));
  }
  [[nodiscard]] bool all_reached() const;
};

/// The scenario of a driver on the map of a seed, from corner to corner.
[[nodiscard]] Scenario drive_scenario(DriveCourse course,
                                      std::uint64_t seed,
                                      DriverKind kind,
                                      const Settings& ours = {});

/// Runs a scenario of one robot.
[[nodiscard]] Drive drive(const Scenario& scenario, const StudyOptions& options);

/// Compares `maps` maps on which every driver has a plan, starting at `options.seed`.
/// @pre maps > 0.
[[nodiscard]] std::vector<DriveComparison> compare_drivers(DriveCourse course,
                                                           int maps,
                                                           const StudyOptions& options);

}  // namespace fairway::reproduction
