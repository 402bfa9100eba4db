// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "experiments/paper/studies/drive_study.hpp"
#include "experiments/paper/studies/sample_statistics.hpp"

namespace fairway::reproduction {

/// All maps of one course.
struct DriveRuns {
  DriveCourse course = DriveCourse::Structured;
  std::vector<DriveComparison> maps;

  /// The maps on which all drivers reached the goal; only these are compared.
  [[nodiscard]] std::vector<const DriveComparison*> comparable() const;
  [[nodiscard]] int reached(DriverKind kind) const;
  [[nodiscard]] int collided(DriverKind kind) const;
};

/// The measures that are compared.
enum class DriveMeasure : std::uint8_t { Length, Time, Smoothness, Switches };
inline constexpr std::array kDriveMeasures = {DriveMeasure::Length, DriveMeasure::Time,
                                              DriveMeasure::Smoothness, DriveMeasure::Switches};

/// The name of a measure with its unit.
[[nodiscard]] const char* to_text(DriveMeasure measure) noexcept;

/// The value of a measure for one drive.
[[nodiscard]] double value_of(const Drive& drive, DriveMeasure measure);

/// The values of every comparable map.
[[nodiscard]] std::vector<double> values(const DriveRuns& runs,
                                         DriverKind kind,
                                         DriveMeasure measure);

/// Change from `base` to `kind`, map by map [%].
[[nodiscard]] Estimate change(const DriveRuns& runs,
                              DriverKind kind,
                              DriverKind base,
                              DriveMeasure measure);

}  // namespace fairway::reproduction
