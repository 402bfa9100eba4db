// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <utility>

#include <fmt/format.h>

namespace fairway::app {

namespace {

constexpr double kInterval = 0.2;  // [s]; short work shows nothing at all

}  // namespace

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (shown_at_ > 0.0) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::size_t done) {
  if (!terminal_ || watch_.seconds() < shown_at_ + kInterval) return;
  shown_at_ = watch_.seconds();
  const std::string line = fmt::format("\r{} {} of {}\033[K", what_, done, total_);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace fairway::app
