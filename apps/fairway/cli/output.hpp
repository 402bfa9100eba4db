// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "fairway/base/error.hpp"
#include "fairway/io/maps/map_file.hpp"

namespace fairway::app {

/// JSON whose objects keep the order in which their fields are written.
using Json = nlohmann::ordered_json;

/// Formats `json` as indented text with a final line break. Bytes that are not UTF-8, for example
/// from a file name, become U+FFFD; numbers that are not finite become null.
[[nodiscard]] std::string json_text(const Json& json);

/// Keeps the notes about input files until the command has ended. A command that fails with exit
/// code 2 prints its error and nothing else.
void note(const io::FileNotes& notes);

/// Notes a file that the command reads, for `check_apart`.
void note_input(const std::string& file);

/// The files that the command has read so far, in that order.
[[nodiscard]] const std::vector<std::string>& noted_inputs() noexcept;

/// Notes those files of an input folder whose name `is_input` accepts.
void note_input_folder(const std::string& folder,
                       const std::function<bool(std::string_view)>& is_input);

/// Prints a line per warning, and one with all old names, if any were noted.
void print_warnings();

/// Prints `fairway: message` on standard error, always in one line.
void print_error(std::string_view message);

/// Writes to standard output; a closed pipe is not an error, a full disk is.
[[nodiscard]] Expected<void> print(std::string_view text);

/// Writes `content` to a file, completely or not at all. `-` is standard output; an empty path
/// skips the write.
[[nodiscard]] Expected<void> write_output(const std::string& path, std::string_view content);

/// A file that a command writes, and the option that asks for it.
struct NamedOutput {
  const char* option = "";
  std::string path;  ///< empty: none
};

/// Checks that all outputs differ from each other and from every input noted so far. Links and
/// other spellings of the same file count as equal. Call it before the first output is opened.
[[nodiscard]] Expected<void> check_apart(const std::vector<NamedOutput>& outputs);

/// Whether `write_output` could succeed, for work that is long.
[[nodiscard]] Expected<void> check_output(const std::string& path);

/// Does the same for a picture, whose name must end in .svg, .png or .pdf.
[[nodiscard]] Expected<void> check_picture_output(const std::string& path);

/// Does the same for an animation, whose name must end in .svg.
[[nodiscard]] Expected<void> check_animation_output(const std::string& path);

}  // namespace fairway::app
