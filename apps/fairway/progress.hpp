// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "stopwatch.hpp"

namespace fairway::app {

/// One line on standard error that tells how far long work is, where that is a terminal; nothing
/// otherwise. The line goes away at the end.
class Progress {
 public:
  /// @param what  What is being done, as in "solving".
  Progress(std::string what, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::size_t done);

 private:
  std::string what_;
  std::size_t total_;
  bool terminal_;
  Stopwatch watch_;
  double shown_at_ = 0.0;  // [s]; 0 when the line is empty
};

}  // namespace fairway::app
