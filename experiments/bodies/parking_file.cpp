// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/core.h>

#include "experiments/bodies/body_task.hpp"
#include "fairway/geometry/angle.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/io/whole_file.hpp"
#include "fairway/map/polygon_separation.hpp"

namespace fairway::io {

namespace {

using Eigen::Vector2d;
using Polygon = std::vector<Vector2d>;

constexpr std::size_t kLargestCase = 4U << 20U;  // [bytes]
constexpr double kBorder = 12.0;                 // free floor round start and goal [m]
constexpr double kResolution = 0.05;             // [m]

Expected<std::vector<double>> read_values(const std::string& file) {
  const Expected<std::string> text = read_whole_file(file, kLargestCase);
  if (!text) return tl::unexpected(text.error());
  std::vector<double> values;
  std::string_view rest = *text;
  while (!rest.empty() && std::isspace(static_cast<unsigned char>(rest.back())) != 0)
    rest.remove_suffix(1);
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    std::string_view item = rest.substr(0, comma);
    while (!item.empty() && item.front() == ' ')
      item.remove_prefix(1);
    const std::optional<double> value = parse_number(item);
    if (!value)
      return fail(fmt::format("{}:1: value {}: expected a number, found {}", file,
                              values.size() + 1, excerpt(item)));
    values.push_back(*value);
    rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
  }
  return values;
}

struct ParkingCase {
  Pose2 start;
  Pose2 goal;
  std::vector<Polygon> obstacles;
};

Expected<ParkingCase> read_case(const std::string& file) {
  const Expected<std::vector<double>> values = read_values(file);
  if (!values) return tl::unexpected(values.error());
  const std::vector<double>& v = *values;
  const auto wrong = [&](const std::string& what) {
    return fail(fmt::format("{}:1: {}, found {} numbers", file, what, v.size()));
  };
  if (v.size() < 7) return wrong("expected two poses and the number of obstacles");
  if (!(v[6] >= 0.0 && v[6] <= 10000.0) || v.size() < 7 + static_cast<std::size_t>(v[6]))
    return wrong("expected a count of vertices for every obstacle");
  const auto count = static_cast<std::size_t>(v[6]);
  // Coordinates may be billions of metres from the origin: shift by an integer, which is exact.
  const Vector2d shift(std::floor(std::min(v[0], v[3])), std::floor(std::min(v[1], v[4])));
  ParkingCase result;
  result.start = {.position = Vector2d(v[0], v[1]) - shift, .heading = wrap_to_pi(v[2])};
  result.goal = {.position = Vector2d(v[3], v[4]) - shift, .heading = wrap_to_pi(v[5])};
  std::size_t next = 7 + count;
  for (std::size_t i = 0; i < count; ++i) {
    const double vertices = v[7 + i];
    if (!(vertices >= 3.0 && vertices <= 10000.0) ||
        next + 2 * static_cast<std::size_t>(vertices) > v.size())
      return wrong(fmt::format("obstacle {}: expected at least 3 vertices", i + 1));
    Polygon polygon;
    for (std::size_t k = 0; k < static_cast<std::size_t>(vertices); ++k, next += 2)
      polygon.push_back(Vector2d(v[next], v[next + 1]) - shift);
    result.obstacles.push_back(std::move(polygon));
  }
  return result;
}

bool holds(const Polygon& polygon, const Vector2d& point) noexcept {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector2d& a = polygon[i];
    const Vector2d& b = polygon[j];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
      inside = !inside;
  }
  return inside;
}

// Marks every cell whose closed square meets a side of the polygon, or whose centre lies in it.
void mark(const Polygon& polygon, OccupancyGrid& grid) {
  const GridFrame& frame = grid.frame();
  Vector2d low = polygon[0];
  Vector2d high = polygon[0];
  for (const Vector2d& vertex : polygon) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  const auto cells = [&](const Vector2d& a, const Vector2d& b, auto&& use) {
    const CellIndex first = frame.cell_at(a.cwiseMin(b));
    const CellIndex last = frame.cell_at(a.cwiseMax(b));
    for (int y = std::max(0, first.y - 1); y <= std::min(frame.height - 1, last.y + 1); ++y) {
      for (int x = std::max(0, first.x - 1); x <= std::min(frame.width - 1, last.x + 1); ++x)
        use(CellIndex{.x = x, .y = y});
    }
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    ConvexPart side;
    side.count = 2;
    side.vertices[0] = frame.to_grid(polygon[i]);
    side.vertices[1] = frame.to_grid(polygon[(i + 1) % polygon.size()]);
    // Only the cells along the side: it is cut into pieces no longer than a few cells.
    const double length = (side.vertices[1] - side.vertices[0]).norm();
    const int count = std::clamp(static_cast<int>(length / 8.0), 1, 100000);
    const Vector2d from = side.vertices[0];
    const Vector2d step = (side.vertices[1] - from) / count;
    for (int k = 0; k < count; ++k) {
      side.vertices[0] = from + k * step;
      side.vertices[1] = from + (k + 1) * step;
      if (side.vertices[1].maxCoeff() < -2.0 || side.vertices[0].minCoeff() > 1e5) continue;
      cells(frame.to_world(side.vertices[0]), frame.to_world(side.vertices[1]),
            [&](CellIndex cell) {
              if (internal::separation(side, cell).distance <= 0.0)
                grid.set(cell, CellState::Occupied);
            });
    }
  }
  cells(low, high, [&](CellIndex cell) {
    if (holds(polygon, frame.center(cell))) grid.set(cell, CellState::Occupied);
  });
}

OccupancyGrid make_map(const ParkingCase& parking) {
  const Vector2d low =
      (parking.start.position.cwiseMin(parking.goal.position).array() - kBorder).floor();
  const Vector2d high =
      (parking.start.position.cwiseMax(parking.goal.position).array() + kBorder).ceil();
  const auto cells = [](double length) {
    return std::clamp(static_cast<int>(std::lround(length / kResolution)), 1, 8000);
  };
  OccupancyGrid grid({.width = cells(high.x() - low.x()),
                      .height = cells(high.y() - low.y()),
                      .resolution = kResolution,
                      .origin = {.position = low, .heading = 0.0}});
  for (const Polygon& polygon : parking.obstacles)
    mark(polygon, grid);
  return grid;
}

// The vehicle of the competition.
BaseModel parking_car() noexcept {
  BaseModel base;
  base.kind = BaseKind::Car;
  base.wheelbase = 2.8;
  base.steering_max = 0.75;
  base.steering_rate_max = 0.5;
  base.linear_min = -2.5;
  base.linear_max = 2.5;
  base.angular_max = 10.0;  // not limited by itself
  base.linear_acceleration = 1.0;
  base.angular_acceleration = 100.0;
  return base;
}

}  // namespace

Expected<std::vector<BodyTask>> read_parking_cases(const std::string& folder,
                                                   const std::vector<std::string>& names) {
  const Expected<std::vector<std::string>> stems = stems_of(folder, ".csv", names);
  if (!stems) return tl::unexpected(stems.error());
  std::vector<BodyTask> tasks;
  for (const std::string& stem : *stems) {
    const Expected<ParkingCase> parking = read_case(stem + ".csv");
    if (!parking) return tl::unexpected(parking.error());
    BodyTask task;
    task.name = std::filesystem::path(stem).filename().string();
    task.map = make_map(*parking);
    task.body = BodyShape::rectangle(4.689, 1.942, 3.76);
    task.base = parking_car();
    task.start = parking->start;
    task.goal = parking->goal;
    task.tolerances = {.position = 0.01, .heading = 0.0175, .linear = 0.01, .angular = 0.01};
    task.time_limit = 300.0;
    tasks.push_back(std::move(task));
  }
  return tasks;
}

}  // namespace fairway::io
