// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "fairway/base/error.hpp"

namespace fairway::app {

/// Objects keep the order in which their fields are written.
using Json = nlohmann::ordered_json;

/// `json` as indented text with a line break at its end. Bytes that are not UTF-8, from a file's
/// name say, become U+FFFD; numbers that are not finite become null.
[[nodiscard]] std::string json_text(const Json& json);

/// Keeps names of settings that were given under their old name, "old (now new)", until the command
/// has ended: a command that fails with exit code 2 prints its error and nothing else.
void note_old_names(const std::vector<std::string>& names);

/// Prints one line with all that was noted, if anything was.
void print_old_names();

/// Prints `fairway: message` on standard error, on one line whatever the message holds.
void print_error(std::string_view message);

/// Writes to standard output; a reader that went away is no error, a full disk is.
[[nodiscard]] Expected<void> print(std::string_view text);

/// Writes `content` to a file, whole or not at all; `-` is standard output, an empty name nowhere.
[[nodiscard]] Expected<void> write_output(const std::string& path, std::string_view content);

/// Whether `write_output` could succeed, for work that is long.
[[nodiscard]] Expected<void> check_output(const std::string& path);

/// The same for a picture, whose name must end in .svg, .png or .pdf.
[[nodiscard]] Expected<void> check_picture_output(const std::string& path);

}  // namespace fairway::app
