// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace fairway::app {

/// A status line on standard error that is rewritten as work proceeds; silent without a terminal.
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();  ///< erases the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows `state`, at most ten times a second.
  void show(const std::string& state);

 private:
  std::string what_;
  bool terminal_;
  double last_ = 0.0;
};

}  // namespace fairway::app
