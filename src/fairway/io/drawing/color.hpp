// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace fairway::io {

/// Red, green, blue and opacity, each 0..1.
struct Color {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
  double alpha = 1.0;

  [[nodiscard]] constexpr Color faded(double opacity) const noexcept {
    return {red, green, blue, opacity};
  }
};

[[nodiscard]] constexpr Color rgb(int red, int green, int blue) noexcept {
  return {red / 255.0, green / 255.0, blue / 255.0, 1.0};
}

/// The palette of Okabe and Ito, which people with colour-vision deficiency can distinguish.
namespace palette {
inline constexpr Color kBlack = rgb(0, 0, 0);
inline constexpr Color kOrange = rgb(230, 159, 0);
inline constexpr Color kSkyBlue = rgb(86, 180, 233);
inline constexpr Color kGreen = rgb(0, 158, 115);
inline constexpr Color kYellow = rgb(240, 228, 66);
inline constexpr Color kBlue = rgb(0, 114, 178);
inline constexpr Color kVermilion = rgb(213, 94, 0);
inline constexpr Color kPurple = rgb(204, 121, 167);
inline constexpr Color kWhite = rgb(255, 255, 255);
inline constexpr Color kGrey = rgb(110, 110, 110);
inline constexpr Color kLightGrey = rgb(225, 225, 225);

/// A colour per robot; repeats after seven.
[[nodiscard]] constexpr Color of_robot(std::size_t index) noexcept {
  constexpr std::array kColors = {kBlue,   kVermilion, kGreen,         kPurple,
                                  kOrange, kSkyBlue,   rgb(90, 60, 20)};
  return kColors.at(index % kColors.size());
}
}  // namespace palette

}  // namespace fairway::io
