// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/scenario/zones_file.hpp"

#include <fmt/core.h>

#include "fairway/io/whole_file.hpp"
#include "fairway/io/yaml/yaml_document.hpp"
#include "fairway/io/yaml/yaml_mapping.hpp"

namespace fairway::io {

namespace {

constexpr std::size_t kLongestZonesFile = 16U << 20;  // [bytes]
constexpr double kUsualPenalty = 4.0;
constexpr double kUsualPreference = 1.0;

double default_weight(ZoneKind kind) {
  if (kind == ZoneKind::Penalty) return kUsualPenalty;
  return kind == ZoneKind::Preferred ? kUsualPreference : 0.0;
}

Zone read_zone(YamlMapping& mapping) {
  Zone zone;
  zone.kind = static_cast<ZoneKind>(mapping.choice("kind", setting_names(ZoneKind{})));
  for (const std::vector<double>& corner : mapping.rows("polygon", 2))
    zone.polygon.emplace_back(corner[0], corner[1]);
  zone.name = mapping.text("name", "");
  const bool has_reference = zone.kind == ZoneKind::KeepOut || zone.kind == ZoneKind::SpeedLimit ||
                             zone.kind == ZoneKind::Strip;
  if (has_reference) {
    const auto usual =
        zone.kind == ZoneKind::Strip ? ZoneReference::Centre : ZoneReference::Contour;
    zone.reference = static_cast<ZoneReference>(mapping.choice(
        "reference", setting_names(ZoneReference{}), static_cast<std::size_t>(usual)));
  }
  if (zone.kind == ZoneKind::SpeedLimit) zone.speed = mapping.number("speed");
  if (zone.kind == ZoneKind::Penalty || zone.kind == ZoneKind::Preferred)
    zone.weight = mapping.number("weight", {}, default_weight(zone.kind));
  if (zone.kind == ZoneKind::OneWay) zone.direction = mapping.number("direction");
  mapping.finish();
  return zone;
}

}  // namespace

Zones read_zones(YamlMapping& root) {
  Zones zones;
  std::size_t corners = 0;
  for (YamlMapping& mapping : root.mappings("zones")) {
    Zone zone = read_zone(mapping);
    if (const std::optional<ZoneFault> fault = find_fault(zone))
      mapping.complain(fault->key, fault->message);
    corners += zone.polygon.size();
    zones.push_back(std::move(zone));
  }
  if (corners > kMostZoneCorners) {
    root.complain("zones", fmt::format("expected at most {} corners in all, found {}",
                                       kMostZoneCorners, corners));
  }
  return zones;
}

Expected<Zones> read_zones_file(const std::string& path) {
  const Expected<std::string> text = read_whole_file(path, kLongestZonesFile);
  if (!text) return tl::unexpected(text.error());
  YamlFile file{.name = path, .error = {}, .warnings = {}};
  YamlMapping root = parse_yaml_mapping(file, *text);
  if (!root.has("zones")) root.complain("zones", "expected a list of zones, found no such key");
  Zones zones = read_zones(root);
  root.finish();
  if (file.error) return tl::unexpected(*file.error);
  return zones;
}

}  // namespace fairway::io
