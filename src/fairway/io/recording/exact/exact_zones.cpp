// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/exact/exact_zones.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "fairway/io/number_text.hpp"
#include "fairway/io/recording/exact/exact_json.hpp"

namespace fairway::io::exact {

namespace {

template <typename Enumeration>
Enumeration named(const Json& json) {
  constexpr auto kNames = setting_names(Enumeration{});
  const auto text = json.get<std::string>();
  const auto found = std::find(kNames.begin(), kNames.end(), text);
  if (found == kNames.end()) throw std::invalid_argument("expected a known kind of zone");
  return static_cast<Enumeration>(found - kNames.begin());
}

}  // namespace

Json to_json(const Zones& zones) {
  Json list = Json::array();
  for (const Zone& zone : zones) {
    Json polygon = Json::array();
    for (const Eigen::Vector2d& corner : zone.polygon)
      polygon.push_back(to_json(corner));
    list.push_back(
        {{"kind", setting_names(zone.kind).at(static_cast<std::size_t>(zone.kind))},
         {"polygon", std::move(polygon)},
         {"reference", setting_names(zone.reference).at(static_cast<std::size_t>(zone.reference))},
         {"speed", to_json(zone.speed)},
         {"weight", to_json(zone.weight)},
         {"direction", to_json(zone.direction)},
         {"name", zone.name}});
  }
  return list;
}

std::string zone_fields(const Zone& zone) {
  std::string text = std::string("kind: ") +
                     setting_names(zone.kind).at(static_cast<std::size_t>(zone.kind)) +
                     ", polygon: [";
  for (std::size_t i = 0; i < zone.polygon.size(); ++i) {
    text += (i == 0 ? "[" : ", [") + number_text(zone.polygon[i].x()) + ", " +
            number_text(zone.polygon[i].y()) + "]";
  }
  text += "]";
  switch (zone.kind) {
    case ZoneKind::SpeedLimit:
      text += ", speed: " + number_text(zone.speed);
      break;
    case ZoneKind::Penalty:
    case ZoneKind::Preferred:
      text += ", weight: " + number_text(zone.weight);
      break;
    case ZoneKind::OneWay:
      text += ", direction: " + number_text(zone.direction);
      break;
    case ZoneKind::KeepOut:
    case ZoneKind::Strip:
      break;
  }
  const bool has_reference = zone.kind == ZoneKind::KeepOut || zone.kind == ZoneKind::SpeedLimit ||
                             zone.kind == ZoneKind::Strip;
  if (has_reference) {
    text += std::string(", reference: ") +
            setting_names(zone.reference).at(static_cast<std::size_t>(zone.reference));
  }
  if (!zone.name.empty()) {
    text += ", name: " + Json(zone.name).dump(-1, ' ', true, Json::error_handler_t::replace);
  }
  return text;
}

Zones to_zones(const Json& json) {
  Zones zones;
  for (const Json& item : json) {
    Zone zone{.kind = named<ZoneKind>(item.at("kind")),
              .polygon = {},
              .reference = named<ZoneReference>(item.at("reference")),
              .speed = to_number(item.at("speed")),
              .weight = to_number(item.at("weight")),
              .direction = to_number(item.at("direction")),
              .name = item.at("name").get<std::string>()};
    for (const Json& corner : item.at("polygon"))
      zone.polygon.push_back(to_point(corner));
    zones.push_back(std::move(zone));
  }
  if (const Expected<void> valid = validate(zones); !valid)
    throw std::invalid_argument(valid.error().message);
  return zones;
}

}  // namespace fairway::io::exact
