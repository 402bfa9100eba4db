// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/whole_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>

#include <fmt/core.h>

namespace fairway::io {

namespace {

namespace fs = std::filesystem;

struct CloseFile {
  void operator()(std::FILE* file) const noexcept { static_cast<void>(std::fclose(file)); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string reason(int error) { return std::generic_category().message(error); }

std::string found(const fs::file_status& status) {
  if (status.type() == fs::file_type::directory) return "a folder";
  if (status.type() == fs::file_type::not_found) return "nothing of that name";
  return "a device or a pipe";
}

bool is_device_or_pipe(const fs::file_status& status) {
  return status.type() == fs::file_type::character || status.type() == fs::file_type::fifo ||
         status.type() == fs::file_type::socket || status.type() == fs::file_type::block;
}

Expected<void> write_all(const std::string& path, std::string_view content) {
  File file(std::fopen(path.c_str(), "wb"));
  if (!file) return fail(fmt::format("{}: cannot be written: {}", path, reason(errno)));
  const bool written = std::fwrite(content.data(), 1, content.size(), file.get()) == content.size();
  // A full disk may become visible only when the buffer is flushed.
  if (!written || std::fflush(file.get()) != 0) {
    return fail(fmt::format("{}: cannot be written: {}", path, reason(errno)));
  }
  return {};
}

}  // namespace

Expected<std::string> read_whole_file(const std::string& path, std::size_t limit) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error && status.type() != fs::file_type::not_found) {
    return fail(fmt::format("{}: expected a readable file, found: {}", path, error.message()));
  }
  if (status.type() != fs::file_type::regular) {
    return fail(fmt::format("{}: expected a file, found {}", path, found(status)));
  }
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return fail(fmt::format("{}: cannot be read: {}", path, error.message()));
  if (size > limit) {
    return fail(
        fmt::format("{}: expected a file of at most {} bytes, found {}", path, limit, size));
  }
  File file(std::fopen(path.c_str(), "rb"));
  if (!file) return fail(fmt::format("{}: cannot be read: {}", path, reason(errno)));
  std::string content(size, '\0');
  content.resize(std::fread(content.data(), 1, content.size(), file.get()));
  if (std::ferror(file.get()) != 0) {
    return fail(fmt::format("{}: cannot be read: {}", path, reason(errno)));
  }
  return content;
}

Expected<void> write_file_atomically(const std::string& path, std::string_view content) {
  if (auto writable = check_writable(path); !writable) return writable;
  std::error_code error;
  if (is_device_or_pipe(fs::status(path, error))) return write_all(path, content);
  // A symbolic link stays; the file behind it is replaced.
  const fs::path target =
      fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : fs::path(path);
  const std::string part = fmt::format("{}.{}.part", target.string(), ::getpid());
  Expected<void> result = write_all(part, content);
  if (result) {
    fs::rename(part, target, error);
    if (error) result = fail(fmt::format("{}: cannot be written: {}", path, error.message()));
  }
  if (!result) fs::remove(part, error);
  return result;
}

Expected<void> check_writable(const std::string& path) {
  std::error_code error;
  if (path.empty()) return fail("expected a file name, found an empty one");
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::directory) {
    return fail(fmt::format("{}: expected a file to write, found a folder", path));
  }
  if (is_device_or_pipe(status)) return {};
  const fs::path parent = fs::path(path).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  if (!fs::is_directory(folder, error)) {
    return fail(fmt::format("{}: expected an existing folder to write to, found no folder {}", path,
                            folder.string()));
  }
  if (::access(folder.c_str(), W_OK) != 0) {
    return fail(fmt::format("{}: cannot be written: {}", path, reason(errno)));
  }
  return {};
}

}  // namespace fairway::io
