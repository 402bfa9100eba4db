// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "fairway/base/error.hpp"

namespace fairway::app {

/// JSON whose objects keep the order in which their fields are written.
using Json = nlohmann::ordered_json;

/// Formats `json` as indented text with a final line break. Bytes that are not UTF-8, for example
/// from a file name, become U+FFFD; numbers that are not finite become null.
[[nodiscard]] std::string json_text(const Json& json);

/// Stores old names of settings, "old (now new)", until the command ends. A command that fails with
/// exit code 2 prints only its error.
void note_old_names(const std::vector<std::string>& names);

/// Prints one line with all stored names, if there are any.
void print_old_names();

/// Prints `fairway: message` on standard error, always in one line.
void print_error(std::string_view message);

/// Writes to standard output; a closed pipe is not an error, a full disk is.
[[nodiscard]] Expected<void> print(std::string_view text);

/// Writes `content` to a file, completely or not at all. `-` is standard output; an empty path
/// skips the write.
[[nodiscard]] Expected<void> write_output(const std::string& path, std::string_view content);

/// Whether `write_output` could succeed; call this before long work.
[[nodiscard]] Expected<void> check_output(const std::string& path);

/// Does the same for a picture, whose name must end in .svg, .png or .pdf.
[[nodiscard]] Expected<void> check_picture_output(const std::string& path);

}  // namespace fairway::app
