// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/studies/field_study.hpp"

#include <algorithm>
#include <optional>
#include <random>

#include "experiments/paper/studies/parallel_runs.hpp"
#include "fairway/corridor/rectangle/largest_rectangle.hpp"
#include "fairway/corridor/rectangle/rectangle_growth.hpp"
#include "fairway/map/free_space.hpp"
#include "fairway/simulation/scenarios/generated_maps.hpp"

namespace fairway::reproduction {

namespace {

using Eigen::Vector2d;

constexpr double kPointRoom = 0.3;  // around each point: Delta_s [m]
constexpr double kReach = 8.0;      // L_max [m]

// Draws points uniformly where a robot of radius Delta_s fits. The standard defines the engine's
// numbers, but not those of its distributions.
std::vector<Vector2d> random_points(const BitGrid& obstacles, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const GridFrame& frame = obstacles.frame();
  const auto draw = [&](int cells) {
    return static_cast<double>(engine() >> 11U) * 0x1.0p-53 * cells * frame.resolution;
  };
  std::vector<Vector2d> points;
  while (points.size() < kFieldPoints) {
    const double x = draw(frame.width);
    const Vector2d p(x, draw(frame.height));
    if (is_free(obstacles, p, p, kPointRoom)) points.push_back(p);
  }
  return points;
}

std::optional<OrientedRectangle> rectangle_at(RectangleKind kind,
                                              const BitGrid& obstacles,
                                              const Vector2d& point) {
  switch (kind) {
    case RectangleKind::Src:
      return grow_rectangle(obstacles, 0.0, point, {.num_orientations = 1, .max_growth = kReach});
    case RectangleKind::Mdsrc:
      return grow_rectangle(obstacles, 0.0, point, {.num_orientations = 10, .max_growth = kReach});
    case RectangleKind::Largest:
      return largest_rectangle(obstacles, 0.0, {.point = point});
  }
  return std::nullopt;
}

Field make_field(std::uint64_t seed, int obstacles_wanted) {
  const BitGrid obstacles(generate_map(MapKind::Field, seed, obstacles_wanted));
  Field field;
  field.points = random_points(obstacles, seed);
  for (std::size_t k = 0; k < kRectangleKinds; ++k) {
    std::vector<OrientedRectangle>& built = field.rectangles.at(k);
    for (const Vector2d& point : field.points) {
      const bool held = std::any_of(built.begin(), built.end(), [&](const auto& rectangle) {
        return rectangle.contains(point);
      });
      if (held) continue;
      const auto made = rectangle_at(static_cast<RectangleKind>(k), obstacles, point);
      if (made) built.push_back(*made);
    }
  }
  return field;
}

}  // namespace

const char* to_text(RectangleKind kind) noexcept {
  switch (kind) {
    case RectangleKind::Src:
      return "SRC";
    case RectangleKind::Mdsrc:
      return "MDSRC";
    case RectangleKind::Largest:
      return "largest (Fairway)";
  }
  return "unknown";
}

double Field::count(RectangleKind kind) const {
  return static_cast<double>(rectangles.at(static_cast<std::size_t>(kind)).size());
}

double Field::mean_area(RectangleKind kind) const {
  double sum = 0.0;
  for (const OrientedRectangle& rectangle : rectangles.at(static_cast<std::size_t>(kind)))
    sum += rectangle.area();
  return sum / std::max(1.0, count(kind));
}

FieldSeries make_fields(std::uint64_t seed) {
  FieldSeries series;
  for (std::size_t i = 0; i < series.size(); ++i)
    series.at(i) = make_field(seed, kFieldObstacles.at(i));
  return series;
}

std::vector<FieldSeries> make_field_series(int count, const StudyOptions& options) {
  return run_all(static_cast<std::size_t>(count), options, "fields",
                 [&](std::size_t i) { return make_fields(map_seed(options, i)); });
}

}  // namespace fairway::reproduction
