// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fairway::io {

/// A decimal number as people and YAML write it: sign, digits, point, exponent, and nothing around
/// it. None for anything else, "nan", "inf" and numbers beyond the range of a double included, so
/// what it returns is always finite. Independent of the locale.
[[nodiscard]] std::optional<double> parse_number(std::string_view text) noexcept;

/// A decimal integer in the range of int, with nothing around it.
[[nodiscard]] std::optional<int> parse_integer(std::string_view text) noexcept;

/// The shortest text that `parse_number` turns back into the same number.
[[nodiscard]] std::string number_text(double value);

/// `text` in a form fit for one line of an error message: at most 40 characters, in quotes, without
/// control characters.
[[nodiscard]] std::string excerpt(std::string_view text);

}  // namespace fairway::io
