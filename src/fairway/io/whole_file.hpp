// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "fairway/base/error.hpp"

namespace fairway::io {

/// Reads a regular file of at most `limit` bytes.
///
/// Anything else under that name (nothing, a folder, a device, a pipe) is an error that starts with
/// `path`.
[[nodiscard]] Expected<std::string> read_whole_file(const std::string& path, std::size_t limit);

/// Writes `content` to a new file beside `path` and then renames it. Readers therefore see either
/// the old or the new file. A device or a pipe is written directly.
[[nodiscard]] Expected<void> write_file_atomically(const std::string& path,
                                                   std::string_view content);

/// Whether `path` could be written now: its folder exists and is writable, and it is not a folder.
/// Call this before long computations.
[[nodiscard]] Expected<void> check_writable(const std::string& path);

}  // namespace fairway::io
