// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/obstruction_text.hpp"

#include <array>
#include <cstdio>

namespace fairway {

std::string fixed_text(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string joined_text(std::initializer_list<std::string_view> pieces) {
  std::string text;
  for (const std::string_view piece : pieces)
    text.append(piece);
  return text;
}

std::string length_text(double length) { return joined_text({fixed_text(length, 3), " m"}); }

std::string place_text(const Eigen::Vector2d& point) {
  return joined_text({"(", fixed_text(point.x(), 2), ", ", fixed_text(point.y(), 2), ")"});
}

}  // namespace fairway
