// SPDX-License-Identifier: Apache-2.0
#include "protocol/messages/action.hpp"

#include <cmath>
#include <cstdlib>

namespace fairway::vda5050 {

const nlohmann::json* Action::parameter(const char* key) const noexcept {
  for (const ActionParameter& given : parameters) {
    if (given.key == key) return &given.value;
  }
  return nullptr;
}

std::optional<std::string> Action::text(const char* key) const {
  const nlohmann::json* value = parameter(key);
  if (value == nullptr || !value->is_string()) return std::nullopt;
  return value->get<std::string>();
}

std::optional<double> Action::number(const char* key) const {
  const nlohmann::json* value = parameter(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_number()) return value->get<double>();
  if (!value->is_string()) return std::nullopt;
  const std::string text = value->get<std::string>();
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const bool whole = !text.empty() && end == text.c_str() + text.size();
  return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

Action read_action(FieldReader& reader) {
  Action action{.type = reader.text("actionType"),
                .id = reader.text("actionId"),
                .blocking = static_cast<BlockingType>(reader.word("blockingType", kBlockingNames)),
                .parameters = {}};
  if (action.id.empty()) reader.complain("actionId", "expected a text that is not empty");
  for (FieldReader& parameter : reader.optional_objects("actionParameters")) {
    const std::string key = parameter.text("key");
    if (!parameter.has("value")) parameter.complain("value", "expected a value, found nothing");
    action.parameters.push_back(
        {.key = key, .value = parameter.has("value") ? parameter.value().at("value") : nullptr});
  }
  return action;
}

}  // namespace fairway::vda5050
