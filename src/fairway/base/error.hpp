// SPDX-License-Identifier: Apache-2.0
#pragma once

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

/// The failed form of every Expected: `return fail("...");`
[[nodiscard]] inline tl::unexpected<Error> fail(std::string message) {
  return tl::unexpected<Error>(Error{std::move(message)});
}

}  // namespace fairway
