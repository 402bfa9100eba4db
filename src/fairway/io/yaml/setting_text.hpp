// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "fairway/base/setting.hpp"
#include "fairway/geometry/footprint.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/io/yaml/yaml_mapping.hpp"

namespace fairway::io {

template <typename Value>
concept NamedEnumeration = std::is_enum_v<Value> && requires(Value value) {
  setting_names(value);
};

/// Describes the allowed values of a setting: "a number from 0 to 10", "mdsrc or fewest".
template <typename Value>
[[nodiscard]] std::string expected_text(const SettingInfo& info) {
  if constexpr (std::same_as<Value, bool>) {
    return "true or false";
  } else if constexpr (NamedEnumeration<Value>) {
    return alternatives(setting_names(Value{}));
  } else if constexpr (std::same_as<Value, BodyDiscs>) {
    return kBodyDiscsExpected;
  } else {
    return describe(std::same_as<Value, int> ? "an integer" : "a number",
                    {.min = info.min, .max = info.max});
  }
}

/// A setting's value as text for a file.
template <typename Value>
[[nodiscard]] std::string value_text(const Value& value) {
  if constexpr (std::same_as<Value, bool>) {
    return value ? "true" : "false";
  } else if constexpr (NamedEnumeration<Value>) {
    return setting_names(value)[static_cast<std::size_t>(value)];
  } else if constexpr (std::same_as<Value, int>) {
    return std::to_string(value);
  } else if constexpr (std::same_as<Value, BodyDiscs>) {
    return to_text(value);
  } else {
    return number_text(value);
  }
}

/// Parses a value; none if `text` is not what `expected_text` describes.
template <typename Value>
[[nodiscard]] std::optional<Value> parse_value(std::string_view text, const SettingInfo& info) {
  if constexpr (std::same_as<Value, bool>) {
    if (text == "true") return true;
    if (text == "false") return false;
    return std::nullopt;
  } else if constexpr (NamedEnumeration<Value>) {
    const auto names = setting_names(Value{});
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (text == names[i]) return static_cast<Value>(i);
    }
    return std::nullopt;
  } else if constexpr (std::same_as<Value, BodyDiscs>) {
    return parse_body_discs(text);
  } else {
    static_assert(std::same_as<Value, int> || std::same_as<Value, double>);
    std::optional<Value> value;
    if constexpr (std::same_as<Value, int>) {
      value = parse_integer(text);
    } else {
      value = parse_number(text);
    }
    return value && *value >= info.min && *value <= info.max ? value : std::nullopt;
  }
}

}  // namespace fairway::io
