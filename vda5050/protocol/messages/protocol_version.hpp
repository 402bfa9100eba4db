// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fairway::vda5050 {

/// Versions of VDA 5050 that a vehicle can use. 2.0.0 differs from 2.1.0 only in its name.
enum class ProtocolVersion : std::uint8_t { V2_0_0, V2_1_0, V3_0_0 };

[[nodiscard]] constexpr const char* to_text(ProtocolVersion version) noexcept {
  switch (version) {
    case ProtocolVersion::V2_0_0:
      return "2.0.0";
    case ProtocolVersion::V2_1_0:
      return "2.1.0";
    case ProtocolVersion::V3_0_0:
      return "3.0.0";
  }
  return "unknown";
}

[[nodiscard]] constexpr std::optional<ProtocolVersion> version_of(std::string_view text) noexcept {
  for (const ProtocolVersion version :
       {ProtocolVersion::V2_0_0, ProtocolVersion::V2_1_0, ProtocolVersion::V3_0_0}) {
    if (text == to_text(version)) return version;
  }
  return std::nullopt;
}

/// Returns whether messages have the form of version 3.
[[nodiscard]] constexpr bool is_v3(ProtocolVersion version) noexcept {
  return version == ProtocolVersion::V3_0_0;
}

/// The identity of a vehicle: the levels of its topics and the header of its messages.
struct VehicleIdentity {
  ProtocolVersion version = ProtocolVersion::V2_1_0;
  std::string interface_name;  ///< first level of the topics; empty: as the standard suggests
  std::string manufacturer = "Fairway";
  std::string serial = "amr1";
};

/// Topics of the standard, each the last level of a topic of the broker.
enum class Topic : std::uint8_t {
  Order,
  InstantActions,
  ZoneSet,
  Responses,
  State,
  Visualization,
  Connection,
  Factsheet,
};

[[nodiscard]] constexpr const char* to_text(Topic topic) noexcept {
  switch (topic) {
    case Topic::Order:
      return "order";
    case Topic::InstantActions:
      return "instantActions";
    case Topic::ZoneSet:
      return "zoneSet";
    case Topic::Responses:
      return "responses";
    case Topic::State:
      return "state";
    case Topic::Visualization:
      return "visualization";
    case Topic::Connection:
      return "connection";
    case Topic::Factsheet:
      return "factsheet";
  }
  return "unknown";
}

/// Returns the topic on the broker: INTERFACE/vMAJOR/MANUFACTURER/SERIAL/TOPIC.
[[nodiscard]] inline std::string topic_path(const VehicleIdentity& vehicle, Topic topic) {
  const bool third = is_v3(vehicle.version);
  std::string name = vehicle.interface_name;
  if (name.empty()) name = third ? "vda5050" : "uagv";
  return name + (third ? "/v3/" : "/v2/") + vehicle.manufacturer + "/" + vehicle.serial + "/" +
         to_text(topic);
}

/// Returns whether a text can be a serial number: letters, digits and `_ . : -`.
[[nodiscard]] inline bool is_serial_number(std::string_view text) noexcept {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == ':' || c == '-';
  };
  for (const char c : text) {
    if (!allowed(c)) return false;
  }
  return !text.empty();
}

/// Returns whether a text can be a level of a topic: not empty, without `/ + # $`.
[[nodiscard]] inline bool is_topic_level(std::string_view text) noexcept {
  return !text.empty() && text.find_first_of("/+#$") == std::string_view::npos;
}

}  // namespace fairway::vda5050
