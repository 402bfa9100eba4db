// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "experiments/paper/studies/study_options.hpp"
#include "fairway/geometry/oriented_rectangle.hpp"

namespace fairway::reproduction {

/// Numbers of obstacles in the fields of Figures 9 and 10.
inline constexpr std::array kFieldObstacles = {5, 10, 15, 20};
/// Random points per field.
inline constexpr int kFieldPoints = 24;

/// How a rectangle is made around a point.
enum class RectangleKind : std::uint8_t {
  Src,      ///< one orientation
  Mdsrc,    ///< ten orientations
  Largest,  ///< ours: the largest over all orientations
};
inline constexpr std::size_t kRectangleKinds = 3;

[[nodiscard]] const char* to_text(RectangleKind kind) noexcept;

/// One field: a rectangle around each point that no earlier rectangle contains. The rectangles are
/// free by the exact test (no samples), so that areas are comparable.
struct Field {
  std::vector<Eigen::Vector2d> points;
  std::array<std::vector<OrientedRectangle>, kRectangleKinds> rectangles;

  [[nodiscard]] double count(RectangleKind kind) const;
  [[nodiscard]] double mean_area(RectangleKind kind) const;  ///< [m^2]
};

/// The fields of one seed, one per entry of kFieldObstacles.
using FieldSeries = std::array<Field, kFieldObstacles.size()>;

[[nodiscard]] FieldSeries make_fields(std::uint64_t seed);

/// Makes `count` series, starting at `options.seed`.
[[nodiscard]] std::vector<FieldSeries> make_field_series(int count, const StudyOptions& options);

}  // namespace fairway::reproduction
