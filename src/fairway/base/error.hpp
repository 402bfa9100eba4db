// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

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

/// Makes the failed form of every Expected, with a message of one line of valid UTF-8:
/// `return fail("...");`.
[[nodiscard]] tl::unexpected<Error> fail(std::string_view message);

}  // namespace fairway
