// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "fairway/geometry/footprint.hpp"
#include "protocol/messages/timestamp.hpp"
#include "protocol/vehicle/vehicle.hpp"

namespace fairway::vda5050 {

namespace {

constexpr std::size_t kLongestMessage = 16U << 20U;  // [bytes]

// Checks the header of a message, and that its major version is that of the vehicle.
void check_header(FieldReader& reader, ProtocolVersion version) {
  (void)reader.count("headerId");
  (void)reader.text("manufacturer");
  (void)reader.text("serialNumber");
  const std::string time = reader.text("timestamp");
  if (reader.sound() && !from_timestamp(time))
    reader.complain("timestamp", "expected a time of ISO 8601, found \"" + time + "\"");
  const std::string given = reader.text("version");
  const std::string own = to_text(version);
  if (reader.sound() && given.substr(0, 2) != own.substr(0, 2))
    reader.complain("version", "expected " + own + ", found \"" + given + "\"");
}

}  // namespace

Vehicle::Vehicle(VehicleIdentity identity, VehicleDescription description, std::string map_id)
    : identity_(std::move(identity)),
      description_(std::move(description)),
      map_id_(std::move(map_id)),
      body_(footprint_of(description_.robot).inscribed_radius()) {}

void Vehicle::receive(Topic topic, std::string_view payload, double now) {
  using nlohmann::json;
  const json message = payload.size() <= kLongestMessage ? json::parse(payload, nullptr, false)
                                                         : json(json::value_t::discarded);
  if (message.is_discarded()) {
    return refuse_message(topic,
                          payload.size() > kLongestMessage
                              ? "expected a message of at most 16 MB"
                              : "expected JSON in UTF-8, found another text",
                          json::object());
  }
  std::optional<FieldProblem> problem;
  FieldReader reader(message, "", problem);
  check_header(reader, identity_.version);
  if (problem) return refuse_message(topic, problem->text(), message);
  switch (topic) {
    case Topic::Order:
      return receive_order(message, now);
    case Topic::InstantActions:
      return receive_instant_actions(message, now);
    case Topic::ZoneSet:
      return receive_zone_set(message);
    case Topic::Responses:
      return receive_responses(message);
    case Topic::State:
    case Topic::Visualization:
    case Topic::Connection:
    case Topic::Factsheet:
      return;
  }
}

void Vehicle::refuse_message(Topic topic, const std::string& text, const nlohmann::json& message) {
  std::vector<Reference> references{{.key = "topic", .value = to_text(topic)}};
  const auto add = [&](const char* key) {
    if (!message.is_object() || !message.contains(key)) return;
    const nlohmann::json& value = message.at(key);
    references.push_back(
        {.key = key, .value = value.is_string() ? value.get<std::string>() : found_text(value)});
  };
  for (const char* key : {"headerId", "orderId", "orderUpdateId"})
    add(key);
  VehicleError error =
      make_error(Fault::Validation, identity_.version, text, std::move(references));
  if (topic == Topic::Order) return refuse_order(std::move(error));
  std::vector<VehicleError>& errors =
      topic == Topic::InstantActions ? instant_errors_ : zone_errors_;
  if (std::find(errors.begin(), errors.end(), error) == errors.end())
    errors.push_back(std::move(error));
  changed_ = true;
}

void Vehicle::receive_zone_set(const nlohmann::json& message) {
  if (!is_v3(identity_.version)) return;
  std::optional<FieldProblem> problem;
  FieldReader reader(message, "", problem);
  ZoneSet set = read_zone_set(reader);
  if (problem) return refuse_message(Topic::ZoneSet, problem->text(), message);
  changed_ = true;
  const std::string id = set.id;
  if (zone_sets_.add(std::move(set))) {
    zone_errors_.clear();
    return;
  }
  VehicleError error = make_error(Fault::DuplicateZoneSet, identity_.version,
                                  "the zone set is known already; delete it first",
                                  {{.key = "zoneSetId", .value = id}});
  if (std::find(zone_errors_.begin(), zone_errors_.end(), error) == zone_errors_.end())
    zone_errors_.push_back(std::move(error));
}

void Vehicle::receive_responses(const nlohmann::json& message) {
  if (!is_v3(identity_.version)) return;
  std::optional<FieldProblem> problem;
  FieldReader reader(message, "", problem);
  const std::vector<Response> responses = read_responses(reader);
  if (problem) return refuse_message(Topic::Responses, problem->text(), message);
  bool corridors = false;
  bool zones = false;
  for (const Response& response : responses) {
    corridors = leave_.answer(response) || corridors;
    zones = zone_leave_.answer(response) || zones;
  }
  if (zones) update_zone_leave();
  if (corridors) rebuild_route();
  changed_ = changed_ || corridors || zones;
}

}  // namespace fairway::vda5050
