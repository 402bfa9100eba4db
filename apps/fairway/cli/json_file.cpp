// SPDX-License-Identifier: Apache-2.0
#include "cli/json_file.hpp"

#include <algorithm>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "fairway/io/whole_file.hpp"

namespace fairway::app {

namespace {

constexpr std::size_t kLongest = 512U << 20U;  // [bytes]
constexpr int kDeepest = 64;                   // nested lists and objects

bool is_too_deep(const std::string& text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kDeepest) return true;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return false;
}

}  // namespace

Expected<Json> read_json_object(const std::string& path) {
  const Expected<std::string> text = io::read_whole_file(path, kLongest);
  if (!text) return tl::unexpected(text.error());
  if (is_too_deep(*text))
    return fail(fmt::format("{}: expected at most {} nested levels of JSON", path, kDeepest));
  try {
    Json json = Json::parse(*text);
    if (json.is_object()) return json;
    return fail(fmt::format("{}:1: expected a JSON object, found {}", path, json.type_name()));
  } catch (const nlohmann::json::parse_error& error) {
    const auto end =
        text->begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text->size()));
    const auto line = 1 + std::count(text->begin(), end, '\n');
    return fail(fmt::format("{}:{}: expected JSON, found something else at byte {}", path, line,
                            error.byte));
  }
}

}  // namespace fairway::app
