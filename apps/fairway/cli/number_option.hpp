// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <fmt/core.h>

#include "cli/command_line.hpp"
#include "fairway/io/number_text.hpp"

namespace fairway::app {

/// Accepts a finite number from `low` to `high`. (CLI11's own range accepts NaN.)
[[nodiscard]] inline Check number_between(double low, double high) {
  return [low, high](const std::string& text) {
    const std::optional<double> value = io::parse_number(text);
    if (value && *value >= low && *value <= high) return std::string();
    return fmt::format("expected a number from {} to {}, found {}", low, high, io::excerpt(text));
  };
}

}  // namespace fairway::app
