// SPDX-License-Identifier: Apache-2.0
#include "navigation/zone_list.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace fairway::python {

namespace {

[[noreturn]] void refuse_zone(std::size_t index,
                              const std::string& key,
                              const std::string& message) {
  throw std::invalid_argument("zones[" + std::to_string(index) + "]." + key + ": " + message);
}

template <typename Enumeration>
Enumeration choice(std::size_t index, const std::string& key, const py::handle& value) {
  constexpr auto kNames = setting_names(Enumeration{});
  const auto text = py::cast<std::string>(value);
  const auto found = std::find(kNames.begin(), kNames.end(), text);
  if (found == kNames.end()) refuse_zone(index, key, "expected a name of the list, found " + text);
  return static_cast<Enumeration>(found - kNames.begin());
}

void read(Zone& zone, std::size_t index, const std::string& key, const py::handle& value) {
  if (key == "kind") {
    zone.kind = choice<ZoneKind>(index, key, value);
  } else if (key == "reference") {
    zone.reference = choice<ZoneReference>(index, key, value);
  } else if (key == "speed") {
    zone.speed = py::cast<double>(value);
  } else if (key == "weight") {
    zone.weight = py::cast<double>(value);
  } else if (key == "direction") {
    zone.direction = py::cast<double>(value);
  } else if (key == "name") {
    zone.name = py::cast<std::string>(value);
  } else if (key == "polygon") {
    for (const py::handle corner : py::cast<py::sequence>(value)) {
      const auto point = py::cast<py::sequence>(corner);
      if (point.size() != 2) refuse_zone(index, key, "expected corners [x, y]");
      zone.polygon.emplace_back(py::cast<double>(point[0]), py::cast<double>(point[1]));
    }
  } else {
    refuse_zone(index, key, "expected a key of a zone, found an unknown one");
  }
}

}  // namespace

Zones zones_of(const py::sequence& list) {
  constexpr double kUsualPenalty = 4.0;
  constexpr double kUsualPreference = 1.0;
  Zones zones;
  for (const py::handle item : list) {
    const auto mapping = py::cast<py::dict>(item);
    Zone zone;
    if (!mapping.contains("kind"))
      refuse_zone(zones.size(), "kind", "expected a kind, found no such key");
    zone.kind = choice<ZoneKind>(zones.size(), "kind", mapping["kind"]);
    if (zone.kind == ZoneKind::Strip) zone.reference = ZoneReference::Centre;
    if (zone.kind == ZoneKind::Penalty) zone.weight = kUsualPenalty;
    if (zone.kind == ZoneKind::Preferred) zone.weight = kUsualPreference;
    for (const auto& [key, value] : mapping)
      read(zone, zones.size(), py::cast<std::string>(key), value);
    zones.push_back(std::move(zone));
  }
  return zones;
}

}  // namespace fairway::python
