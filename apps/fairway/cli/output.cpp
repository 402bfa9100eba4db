// SPDX-License-Identifier: Apache-2.0
#include "cli/output.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "fairway/base/utf8_text.hpp"
#include "fairway/io/drawing/canvas.hpp"
#include "fairway/io/whole_file.hpp"

namespace fairway::app {

namespace {

namespace fs = std::filesystem;

// Of the one command that a process carries out.
io::FileNotes& noted() {
  static io::FileNotes notes;
  return notes;
}

void add_new(const std::vector<std::string>& texts, std::vector<std::string>& all) {
  for (const std::string& text : texts) {
    if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
  }
}

// Whether writing to one would destroy the other. Standard output takes one of them; devices and
// pipes take both.
bool is_same_file(const std::string& one, const std::string& other) {
  if (one.empty() || other.empty()) return false;
  if (one == "-" || other == "-") return one == other;
  std::error_code error;
  const fs::file_status status = fs::status(one, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) return false;
  const auto whole = [&](const std::string& path) {
    return fs::weakly_canonical(fs::absolute(path, error), error);
  };
  return whole(one) == whole(other) || fs::equivalent(one, other, error);
}

}  // namespace

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void note(const io::FileNotes& notes) {
  add_new(notes.files, noted().files);
  add_new(notes.warnings, noted().warnings);
  add_new(notes.old_names, noted().old_names);
}

void note_input(const std::string& file) { add_new({file}, noted().files); }

const std::vector<std::string>& noted_inputs() noexcept { return noted().files; }

void note_input_folder(const std::string& folder,
                       const std::function<bool(std::string_view)>& is_input) {
  std::error_code error;
  fs::directory_iterator files(folder, error);
  for (; !error && files != fs::directory_iterator(); files.increment(error)) {
    if (is_input(files->path().filename().string())) note_input(files->path().string());
  }
}

void print_warnings() {
  for (const std::string& text : noted().warnings)
    print_error("warning: " + text);
  if (noted().old_names.empty()) return;
  print_error(fmt::format("warning: these settings have new names; the old ones work until 1.0: {}",
                          fmt::join(noted().old_names, ", ")));
}

void print_error(std::string_view message) {
  const std::string line = "fairway: " + one_line(message) + '\n';
  static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr));
}

Expected<void> print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if ((written && std::fflush(stdout) == 0) || errno == EPIPE) return {};
  return fail(fmt::format("standard output: cannot be written: {}",
                          std::generic_category().message(errno)));
}

Expected<void> write_output(const std::string& path, std::string_view content) {
  if (path.empty()) return {};
  return path == "-" ? print(content) : io::write_file_atomically(path, content);
}

Expected<void> check_output(const std::string& path) {
  if (path.empty() || path == "-") return {};
  return io::check_writable(path);
}

Expected<void> check_apart(const std::vector<NamedOutput>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const NamedOutput& one = outputs[i];
    for (std::size_t k = i + 1; k < outputs.size(); ++k) {
      if (!is_same_file(one.path, outputs[k].path)) continue;
      return fail(fmt::format("{}: expected a file other than that of {}, found {} for both",
                              outputs[k].option, one.option,
                              one.path == "-" ? "standard output" : one.path));
    }
    for (const std::string& input : noted().files) {
      if (!is_same_file(one.path, input)) continue;
      return fail(
          fmt::format("{}: expected a file other than the input, found {}", one.option, one.path));
    }
  }
  return {};
}

Expected<void> check_picture_output(const std::string& path) {
  if (path.empty()) return {};
  if (const auto format = io::picture_format(path); !format) return tl::unexpected(format.error());
  return io::check_writable(path);
}

Expected<void> check_animation_output(const std::string& path) {
  if (path.empty()) return {};
  const auto format = io::picture_format(path);
  if (!format || *format != io::PictureFormat::Svg)
    return fail("--animation: expected a file that ends in .svg, found " + io::excerpt(path));
  return io::check_writable(path);
}

}  // namespace fairway::app
