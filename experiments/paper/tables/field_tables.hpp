// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/field_study.hpp"
#include "experiments/paper/studies/sample_statistics.hpp"

namespace fairway::reproduction {

/// The compared values, in the order of tables and figures.
inline constexpr std::array kComparedRectangles = {RectangleKind::Src, RectangleKind::Mdsrc,
                                                   RectangleKind::Largest};

/// The fields of several seeds; Figure 9 shows the first.
struct FieldSample {
  std::uint64_t first_seed = 0;
  std::vector<FieldSeries> series;

  /// One value of every field with the given number of obstacles (by its index in kFieldObstacles).
  [[nodiscard]] std::vector<double> counts(std::size_t obstacles, RectangleKind kind) const;
  [[nodiscard]] std::vector<double> areas(std::size_t obstacles, RectangleKind kind) const;
};

/// The relative excess of MDSRC over SRC, field by field, with one number of obstacles [%].
[[nodiscard]] std::vector<double> area_gain(const FieldSample& sample, std::size_t obstacles);
[[nodiscard]] std::vector<double> count_gain(const FieldSample& sample, std::size_t obstacles);

/// The values behind Figure 10, with the tests.
[[nodiscard]] Table field_table(const FieldSample& sample);
[[nodiscard]] Json field_numbers(const FieldSample& sample);

/// Gain of MDSRC over SRC with 20 obstacles minus that with 5, field by field [percentage points].
/// Positive means that the advantage grows.
[[nodiscard]] Estimate area_gain_growth(const FieldSample& sample);
[[nodiscard]] Estimate count_gain_growth(const FieldSample& sample);

}  // namespace fairway::reproduction
