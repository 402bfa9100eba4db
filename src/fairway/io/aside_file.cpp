// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/aside_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "fairway/io/whole_file.hpp"

namespace fairway::io {

namespace {

namespace fs = std::filesystem;

std::string errno_text(int error) { return std::generic_category().message(error); }

// A link stays a link: the file that it names is the one to replace.
std::string target_of(const std::string& path) {
  std::error_code error;
  return fs::is_symlink(path, error) ? fs::weakly_canonical(path, error).string() : path;
}

bool exists_and_is_no_file(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status);
}

// Whether the open file still has this name: another task may have renamed it before the lock.
bool is_open_file(int descriptor, const std::string& name) {
  struct stat open {};
  struct stat named {};
  return ::fstat(descriptor, &open) == 0 && ::stat(name.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

}  // namespace

AsideFile::AsideFile(std::string path, std::string part, int descriptor)
    : path_(std::move(path)),
      target_(target_of(path_)),
      part_(std::move(part)),
      descriptor_(descriptor) {}

AsideFile::~AsideFile() {
  if (descriptor_ < 0) return;
  if (!part_.empty()) ::unlink(part_.c_str());
  ::close(descriptor_);
}

Expected<std::unique_ptr<AsideFile>> AsideFile::create(const std::string& path) {
  if (auto possible = check_writable(path); !possible) return tl::unexpected(possible.error());
  constexpr mode_t kMode = 0666;  // less the umask
  if (exists_and_is_no_file(path)) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0)
      return fail(fmt::format("{}: cannot be written: {}", path, errno_text(errno)));
    return std::unique_ptr<AsideFile>(new AsideFile(path, "", descriptor));
  }
  const std::string part = target_of(path) + ".part";
  const int descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, kMode);
  if (descriptor < 0)
    return fail(fmt::format("{}: cannot be written: {}", part, errno_text(errno)));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 || !is_open_file(descriptor, part)) {
    ::close(descriptor);
    return fail(
        fmt::format("{}: expected a file that nothing else writes, found another run that "
                    "does",
                    path));
  }
  std::unique_ptr<AsideFile> file(new AsideFile(path, part, descriptor));
  if (::ftruncate(descriptor, 0) != 0) {  // what a killed task has left
    return fail(fmt::format("{}: cannot be written: {}", part, errno_text(errno)));
  }
  return file;
}

void AsideFile::write(std::string_view bytes) noexcept {
  while (failure_ == 0 && !bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      failure_ = errno;
    }
  }
}

Expected<void> AsideFile::commit() {
  if (failure_ == 0 && !part_.empty() && ::rename(part_.c_str(), target_.c_str()) != 0)
    failure_ = errno;
  if (failure_ != 0)
    return fail(fmt::format("{}: cannot be written: {}", path_, errno_text(failure_)));
  ::close(std::exchange(descriptor_, -1));
  return {};
}

}  // namespace fairway::io
