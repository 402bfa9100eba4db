// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fairway::io {

/// Parses a decimal number: sign, digits, point and exponent, and nothing around it. Anything else
/// gives none, including "nan", "inf" and numbers beyond a double's range, so the result is always
/// finite. Independent of the locale.
[[nodiscard]] std::optional<double> parse_number(std::string_view text) noexcept;

/// Parses a decimal integer in the range of int, with nothing around it.
[[nodiscard]] std::optional<int> parse_integer(std::string_view text) noexcept;

/// The shortest text that `parse_number` converts to the same number.
[[nodiscard]] std::string number_text(double value);

/// Shortens `text` for one line of an error message: at most 40 characters, in quotes, without
/// control characters.
[[nodiscard]] std::string excerpt(std::string_view text);

}  // namespace fairway::io
