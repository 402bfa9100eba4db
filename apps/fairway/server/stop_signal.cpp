// SPDX-License-Identifier: Apache-2.0
#include "server/stop_signal.hpp"

#include <pthread.h>

#include <chrono>
#include <cstdlib>
#include <utility>

namespace fairway::app {

namespace {

constexpr std::chrono::milliseconds kPatience(1500);  // until the process is ended

}  // namespace

StopSignal::StopSignal(std::function<void()> on_signal) : on_signal_(std::move(on_signal)) {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  thread_ = std::thread([this] { run(); });
}

StopSignal::~StopSignal() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  wake_.notify_all();
  pthread_kill(thread_.native_handle(), SIGTERM);  // it may still wait for one
  thread_.join();
}

void StopSignal::run() {
  int signal = 0;
  sigwait(&signals_, &signal);
  std::unique_lock lock(mutex_);
  if (over_) return;
  lock.unlock();
  on_signal_();
  lock.lock();
  if (!wake_.wait_for(lock, kPatience, [this] { return over_; })) std::_Exit(EXIT_SUCCESS);
}

}  // namespace fairway::app
