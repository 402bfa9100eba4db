// SPDX-License-Identifier: Apache-2.0
// What a live world does with its zones when it is asked.
#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "server/live_world.hpp"

namespace fairway::app {

namespace {

constexpr std::size_t kMostZones = 100;

}  // namespace

void LiveWorld::set_zones(EpisodeControl& control, const Zones& zones) {
  scenario_.zones = zones;
  control.set_zones(zones);
}

void LiveWorld::change_zones(EpisodeControl& control, std::string label, const Zones& zones) {
  const auto use = [this](const Zones& then) {
    return [this, then](EpisodeControl& to) { set_zones(to, then); };
  };
  Edit edit{.label = std::move(label), .undo = use(scenario_.zones), .redo = use(zones)};
  set_zones(control, zones);
  edited(std::move(edit));
}

void LiveWorld::apply(EpisodeControl& control, const ZoneCommand& command) {
  const std::optional<Eigen::Vector2d> at =
      command.zone.polygon.empty() ? std::nullopt : std::optional(command.zone.polygon.front());
  Zones zones = scenario_.zones;
  if (command.index && *command.index >= zones.size()) return refuse("There is no such zone.");
  if (!command.index && zones.size() >= kMostZones)
    return refuse(fmt::format("Zone limit reached ({}).", kMostZones), at);
  if (const auto fault = find_fault(command.zone))
    return refuse(fmt::format("Zone: {}: {}.", fault->key, fault->message), at);
  const auto& robots = scenario_.robots;
  if (std::any_of(robots.begin(), robots.end(), [](const RobotTask& task) { return task.model; }))
    return refuse("Zones do not hold for robots with a body of their own.", at);
  if (command.index) {
    std::string name = zones[*command.index].name;
    zones[*command.index] = command.zone;
    zones[*command.index].name = std::move(name);
  } else {
    zones.push_back(command.zone);
  }
  change_zones(control, command.index ? "change zone" : "add zone", zones);
}

void LiveWorld::apply(EpisodeControl& control, const RemoveZoneCommand& command) {
  Zones zones = scenario_.zones;
  if (command.index >= zones.size()) return refuse("There is no such zone.");
  zones.erase(zones.begin() + static_cast<std::ptrdiff_t>(command.index));
  change_zones(control, "remove zone", zones);
}

}  // namespace fairway::app
