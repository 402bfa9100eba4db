// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.hpp"

#include <unistd.h>

#include <cstdio>

#include "experiments/clocks.hpp"

namespace fairway::app {

Progress::Progress(std::string what)
    : what_(std::move(what)),
      terminal_(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (terminal_ && last_ > 0.0) std::fputs("\r\033[K", stderr);
}

void Progress::show(const std::string& state) {
  constexpr double kPeriod = 0.1;  // [s]
  if (!terminal_ || steady_seconds() - last_ < kPeriod) return;
  last_ = steady_seconds();
  std::fprintf(stderr, "\r\033[K%s: %s", what_.c_str(), state.c_str());
  std::fflush(stderr);
}

}  // namespace fairway::app
