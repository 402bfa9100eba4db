// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace fairway {

/// Why something from outside (a file, a key, a number) could not be used: one line for a person.
///
/// Form: `FILE:LINE: key: expected ..., found ...`, as far as these apply.
struct Error {
  std::string message;
};

/// A value, or the reason why there is none.
template <typename T>
using Expected = tl::expected<T, Error>;

/// `text` with a space for every control character: what was found in a file, or a file's name, may
/// hold line breaks.
[[nodiscard]] inline std::string one_line(std::string text) {
  const auto is_control = [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20 || code == 0x7f;
  };
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  return text;
}

/// The failed form of every Expected: `return fail("...");` Makes one line of the message.
[[nodiscard]] inline tl::unexpected<Error> fail(std::string message) {
  return tl::unexpected<Error>(Error{one_line(std::move(message))});
}

}  // namespace fairway
