// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "fairway/base/error.hpp"

namespace fairway::io {

/// The bytes of a regular file of at most `limit` bytes.
///
/// Anything else that a name can stand for (nothing, a folder, a device, a pipe) is an error that
/// starts with `path`.
[[nodiscard]] Expected<std::string> read_whole_file(const std::string& path, std::size_t limit);

/// Writes `content` to a new file beside `path` and then renames it, so that readers see the old
/// file or the whole new one. Writes straight to `path` where that is a device or a pipe.
[[nodiscard]] Expected<void> write_file_atomically(const std::string& path,
                                                   std::string_view content);

/// Whether `path` could be written now: its folder exists and is writable, and it is no folder
/// itself. For long work that should not fail at its very end.
[[nodiscard]] Expected<void> check_writable(const std::string& path);

}  // namespace fairway::io
