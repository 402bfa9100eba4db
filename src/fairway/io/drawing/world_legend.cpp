// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/drawing/world_legend.hpp"

#include <algorithm>

#include "fairway/io/drawing/map_raster.hpp"
#include "fairway/io/drawing/zone_shapes.hpp"

namespace fairway::io {

namespace {

using Kind = LegendEntry::Kind;

LegendEntry line_entry(std::string text, const Stroke& stroke) {
  return {.kind = Kind::Line, .text = std::move(text), .stroke = stroke};
}

void add_map_entries(std::vector<LegendEntry>& entries,
                     const OccupancyGrid& map,
                     const Box& region) {
  const Stroke thin{.color = palette::kGrey, .width = 0.5};
  for (const CellState state : {CellState::Occupied, CellState::Unknown}) {
    if (!shows(map, region, state)) continue;
    const bool occupied = state == CellState::Occupied;
    entries.push_back({.kind = Kind::Area,
                       .text = occupied ? "occupied" : "unknown",
                       .stroke = thin,
                       .fill = occupied ? kOccupiedColor : kUnknownColor});
  }
}

void add_track_entries(std::vector<LegendEntry>& entries, const WorldDrawing& world) {
  const std::size_t count = world.robots.size();
  constexpr std::size_t kMostNames = 6;
  if (count == 1 || count > kMostNames) {
    const Color color = count == 1 ? RobotColors{}.track : palette::kGrey;
    entries.push_back(
        line_entry(count == 1 ? "trajectory" : "trajectories", {.color = color, .width = 1.8}));
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    entries.push_back(
        line_entry(world.robots[i].name, {.color = palette::of_robot(i), .width = 1.8}));
  }
}

}  // namespace

RobotColors colors_of(std::size_t robot, std::size_t count) {
  if (count <= 1) return {};
  const Color color = palette::of_robot(robot);
  return {.corridor = color, .path = color, .seed = color, .track = color};
}

std::vector<LegendEntry> world_legend(const WorldDrawing& world, const Box& region) {
  std::vector<LegendEntry> entries;
  if (world.map != nullptr) add_map_entries(entries, *world.map, region);
  add_zone_entries(entries, world.zones);
  const Color grey = palette::kGrey;
  const RobotColors colors =
      world.robots.size() > 1
          ? RobotColors{.corridor = grey, .path = grey, .seed = grey, .track = grey}
          : RobotColors{};
  const auto with = [&](auto&& part) {
    return std::find_if(world.robots.begin(), world.robots.end(),
                        [&](const RobotDrawing& robot) { return !part(robot).empty(); });
  };
  const auto planned =
      with([](const RobotDrawing& r) -> const auto& { return r.corridor.rectangles; });
  if (planned != world.robots.end()) {
    const bool workspace = planned->corridor.space == CorridorSpace::Workspace;
    entries.push_back({.kind = Kind::Area,
                       .text = workspace ? "safe rectangle" : "safe rectangle (robot's centre)",
                       .stroke = {.color = colors.corridor, .width = 0.9},
                       .fill = colors.corridor.faded(world.robots.size() > 1 ? 0.0 : 0.10)});
    entries.push_back({.kind = Kind::Dot,
                       .text = "seed",
                       .stroke = {.color = palette::kWhite, .width = 0.6},
                       .fill = colors.seed});
  }
  if (with([](const RobotDrawing& r) -> const auto& { return r.path.waypoints; }) !=
      world.robots.end()) {
    entries.push_back(line_entry("path", {.color = colors.path, .width = 1.3, .dash = {4.0, 2.5}}));
  }
  if (with([](const RobotDrawing& r) -> const auto& { return r.track; }) != world.robots.end()) {
    add_track_entries(entries, world);
  }
  if (!world.bodies.empty()) {
    entries.push_back(line_entry("moving obstacle", kBodyStroke));
  }
  entries.push_back(
      {.kind = Kind::Ring, .text = "start", .stroke = {.color = colors.track, .width = 1.2}});
  entries.push_back(
      {.kind = Kind::Cross, .text = "goal", .stroke = {.color = colors.track, .width = 1.6}});
  return entries;
}

}  // namespace fairway::io
