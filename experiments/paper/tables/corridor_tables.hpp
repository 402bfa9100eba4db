// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/corridor_study.hpp"
#include "experiments/paper/studies/sample_statistics.hpp"

namespace fairway::reproduction {

/// All maps of one kind, with its name for the reader.
struct CorridorEnvironment {
  MapKind kind = MapKind::UnstructuredLarge;
  std::string name;
  std::vector<CorridorComparison> maps;
};

/// The comparison of one method with another on the same maps.
struct CorridorGain {
  Estimate fewer;           ///< change of the number of rectangles, per map [%]
  Estimate larger;          ///< change of the mean area relative to the other's, per map [%]
  Estimate larger_of_own;   ///< the same relative to its own area: the paper's base [%]
  TestResult count_welch;   ///< of equal numbers, as two samples
  TestResult count_paired;  ///< of equal numbers, map by map
  TestResult area_welch;
  TestResult area_paired;
};

[[nodiscard]] CorridorGain gain_over(const std::vector<CorridorComparison>& maps,
                                     CorridorKind method,
                                     CorridorKind other);

/// Table II with the paper's columns; times are in corridor_times.
[[nodiscard]] Table table_two(const std::vector<CorridorEnvironment>& environments);
/// The percentages, with their reference values.
[[nodiscard]] Table gain_table(const std::vector<CorridorEnvironment>& environments);
/// The numbers of rectangles that touch obstacles and of broken chains.
[[nodiscard]] Table soundness_table(const std::vector<CorridorEnvironment>& environments);
/// Column TS of Table II [s].
[[nodiscard]] Table corridor_times(const std::vector<CorridorEnvironment>& environments);

[[nodiscard]] Json corridor_numbers(const std::vector<CorridorEnvironment>& environments);
[[nodiscard]] Json corridor_timing(const std::vector<CorridorEnvironment>& environments);

}  // namespace fairway::reproduction
