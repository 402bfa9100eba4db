// SPDX-License-Identifier: Apache-2.0
#include "server/live_maps.hpp"

#include <cmath>
#include <utility>

#include "fairway/map/distance_field.hpp"
#include "fairway/simulation/scenarios/generated_maps.hpp"

namespace fairway::app {

namespace {

constexpr double kRoom = 0.15;  // beyond the robot's radius, where it starts and ends [m]

// Searches breadth first over the cells with clearance around `start`; returns the cell that is
// reached last.
CellIndex furthest(const DistanceField& distances, double room, CellIndex start) {
  const GridFrame& frame = distances.frame();
  const auto number = [&](CellIndex cell) {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(frame.width) +
           static_cast<std::size_t>(cell.x);
  };
  std::vector<bool> seen(static_cast<std::size_t>(frame.width) *
                         static_cast<std::size_t>(frame.height));
  std::vector<CellIndex> queue{start};
  seen[number(start)] = true;
  for (std::size_t at = 0; at < queue.size(); ++at) {
    const CellIndex cell = queue[at];
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const CellIndex next{.x = cell.x + dx, .y = cell.y + dy};
      if (distances.at(next) < room || seen[number(next)]) continue;
      seen[number(next)] = true;
      queue.push_back(next);
    }
  }
  return queue.back();
}

CellIndex roomiest(const DistanceField& distances) {
  const auto cells = distances.cells();
  std::size_t best = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (cells[i] > cells[best]) best = i;
  }
  const auto width = static_cast<std::size_t>(distances.frame().width);
  return {.x = static_cast<int>(best % width), .y = static_cast<int>(best / width)};
}

Scenario generated(const char* name, MapKind kind, std::uint64_t seed) {
  return scenario_on(name, generate_map(kind, seed));
}

Scenario hall() {
  OccupancyGrid map(GridFrame{.width = 400, .height = 300, .resolution = 0.05, .origin = {}});
  constexpr int kWall = 3;  // [cells]
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 400; ++x) {
      if (x < kWall || y < kWall || x >= 400 - kWall || y >= 300 - kWall) {
        map.set({.x = x, .y = y}, CellState::Occupied);
      }
    }
  }
  Scenario scenario = scenario_on("Empty hall", map);
  scenario.robots.front().start = {.position = {2.0, 2.0}, .heading = 0.6};
  scenario.robots.front().goal = {.position = {17.0, 13.0}, .heading = {}};
  return scenario;
}

}  // namespace

Scenario scenario_on(const std::string& name, const OccupancyGrid& map) {
  Scenario scenario;
  scenario.name = name;
  scenario.map = map;
  const DistanceField distances{BitGrid(map, unknown_cells(scenario.settings.map))};
  const double room = scenario.settings.robot.radius + kRoom;
  const CellIndex one = furthest(distances, room, roomiest(distances));
  const CellIndex other = furthest(distances, room, one);
  const Eigen::Vector2d start = map.frame().center(one);
  const Eigen::Vector2d goal = map.frame().center(other);
  const Eigen::Vector2d way = goal - start;
  scenario.robots = {{.name = "robot",
                      .start = {.position = start, .heading = std::atan2(way.y(), way.x())},
                      .goal = {.position = goal, .heading = {}}}};
  return scenario;
}

std::vector<MapChoice> built_in_maps() {
  return {{.name = "Rooms", .make = [] { return generated("Rooms", MapKind::Structured, 4); }},
          {.name = "Clutter, 20 m",
           .make = [] { return generated("Clutter, 20 m", MapKind::Field, 2); }},
          {.name = "Clutter, 50 m",
           .make = [] { return generated("Clutter, 50 m", MapKind::UnstructuredLarge, 1); }},
          {.name = "Empty hall", .make = hall}};
}

}  // namespace fairway::app
