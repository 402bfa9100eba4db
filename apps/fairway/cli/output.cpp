// SPDX-License-Identifier: Apache-2.0
#include "cli/output.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "fairway/io/drawing/canvas.hpp"
#include "fairway/io/whole_file.hpp"

namespace fairway::app {

namespace {

std::vector<std::string>& old_names() {
  static std::vector<std::string> names;  // of the one command that a process runs
  return names;
}

}  // namespace

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void note_old_names(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (std::find(old_names().begin(), old_names().end(), name) == old_names().end())
      old_names().push_back(name);
  }
}

void print_old_names() {
  if (old_names().empty()) return;
  print_error(fmt::format("warning: these settings have new names; the old ones work until 1.0: {}",
                          fmt::join(old_names(), ", ")));
}

void print_error(std::string_view message) {
  const std::string line = "fairway: " + one_line(std::string(message)) + '\n';
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

Expected<void> check_picture_output(const std::string& path) {
  if (path.empty()) return {};
  if (const auto format = io::picture_format(path); !format) return tl::unexpected(format.error());
  return io::check_writable(path);
}

}  // namespace fairway::app
