// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/drive_study.hpp"
#include "experiments/paper/studies/sample_statistics.hpp"

namespace fairway::reproduction {

/// All maps of one course.
struct DriveRuns {
  DriveCourse course = DriveCourse::Structured;
  std::vector<DriveComparison> maps;

  /// The maps on which all drivers reached the goal: only these can be compared.
  [[nodiscard]] std::vector<const DriveComparison*> comparable() const;
  [[nodiscard]] int reached(DriverKind kind) const;
  [[nodiscard]] int collided(DriverKind kind) const;
};

/// What is compared of runs.
enum class DriveMeasure : std::uint8_t { Length, Time, Smoothness, Switches };
inline constexpr std::array kDriveMeasures = {DriveMeasure::Length, DriveMeasure::Time,
                                              DriveMeasure::Smoothness, DriveMeasure::Switches};

/// Its name with its unit.
[[nodiscard]] const char* to_text(DriveMeasure measure) noexcept;

/// One number of every comparable map.
[[nodiscard]] std::vector<double> values(const DriveRuns& runs,
                                         DriverKind kind,
                                         DriveMeasure measure);

/// Change from `base` to `kind`, map by map [%].
[[nodiscard]] Estimate change(const DriveRuns& runs,
                              DriverKind kind,
                              DriverKind base,
                              DriveMeasure measure);

/// Means of every measure for every driver.
[[nodiscard]] Table drive_table(const DriveRuns& runs);
/// The single map of Figures 5 and 6.
[[nodiscard]] Table drive_example_table(const DriveComparison& map);
/// Changes between drivers with the test.
[[nodiscard]] Table drive_change_table(const DriveRuns& runs);
/// Who arrives where.
[[nodiscard]] Table arrival_table(const std::vector<DriveRuns>& courses);
/// Times per solve.
[[nodiscard]] Table solve_times(const std::vector<DriveRuns>& courses);

[[nodiscard]] Json drive_numbers(const std::vector<DriveRuns>& courses);
[[nodiscard]] Json drive_timing(const std::vector<DriveRuns>& courses);

}  // namespace fairway::reproduction
