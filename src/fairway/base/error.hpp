// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace fairway {

/// Explains to the user, in one line, why a file, a key or a number was rejected.
///
/// The form is `FILE:LINE: key: expected ..., found ...`, as far as these parts apply.
struct Error {
  std::string message;
};

/// Holds a value, or the error that explains why there is none.
template <typename T>
using Expected = tl::expected<T, Error>;

/// Replaces every control character in `text` by a space. Text from a file, or the name of a file,
/// may contain line breaks.
[[nodiscard]] inline std::string one_line(std::string text) {
  const auto is_control = [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20 || code == 0x7f;
  };
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  return text;
}

/// Makes the failed form of every Expected, with a message of one line: `return fail("...");`.
[[nodiscard]] inline tl::unexpected<Error> fail(std::string message) {
  return tl::unexpected<Error>(Error{one_line(std::move(message))});
}

}  // namespace fairway
