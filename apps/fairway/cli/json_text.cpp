// SPDX-License-Identifier: Apache-2.0
#include "cli/json_text.hpp"

namespace fairway::app {

namespace {

bool is_scalar_list(const Json& json) {
  for (const auto& item : json) {
    if (item.is_structured()) return false;
  }
  return true;
}

void append(std::string& text, const Json& json, std::size_t indent) {
  if (!json.is_structured() || json.empty() || (json.is_array() && is_scalar_list(json))) {
    text += json.dump();
    return;
  }
  text += json.is_object() ? "{\n" : "[\n";
  bool first = true;
  for (const auto& [key, value] : json.items()) {
    if (!first) text += ",\n";
    first = false;
    text.append(indent + 2, ' ');
    if (json.is_object()) text += Json(key).dump() + ": ";
    append(text, value, indent + 2);
  }
  text += '\n';
  text.append(indent, ' ');
  text += json.is_object() ? '}' : ']';
}

}  // namespace

std::string json_text(const Json& json) {
  std::string text;
  append(text, json, 0);
  return text + "\n";
}

}  // namespace fairway::app
