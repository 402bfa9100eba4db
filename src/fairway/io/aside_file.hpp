// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "fairway/base/error.hpp"

namespace fairway::io {

/// A file that grows while a long task runs, written aside as `path.part` and renamed when whole.
///
/// An older file of that name stays until then. It stays for good where the task is killed or the
/// disk fills up. A second task that wants the same file is refused while the first one runs. A
/// device or a pipe is written directly.
class AsideFile {
 public:
  [[nodiscard]] static Expected<std::unique_ptr<AsideFile>> create(const std::string& path);

  /// Removes what was written unless it was committed.
  ~AsideFile();
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;

  /// Appends bytes. A failure is kept for `commit`.
  void write(std::string_view bytes) noexcept;

  /// Gives the file its name; the error says why it is not whole.
  [[nodiscard]] Expected<void> commit();

 private:
  AsideFile(std::string path, std::string part, int descriptor);

  std::string path_;
  std::string target_;  // of a link, the file that it names
  std::string part_;    // empty: `path_` is written directly
  int descriptor_;
  int failure_ = 0;  // errno of the first write that failed
};

}  // namespace fairway::io
