// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <csignal>
#include <functional>
#include <mutex>
#include <thread>

namespace fairway::app {

/// Handles SIGINT and SIGTERM in a thread of its own, which calls `on_signal`. If the process has
/// not ended within 1.5 s, because a plan or a download still runs, this ends it.
///
/// Construct it before all other threads: they inherit that these signals are blocked. The signals
/// stay blocked, so use it only in a process that ends with it.
class StopSignal {
 public:
  explicit StopSignal(std::function<void()> on_signal);
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

 private:
  void run();

  std::function<void()> on_signal_;
  sigset_t signals_{};
  std::mutex mutex_;
  std::condition_variable wake_;
  bool over_ = false;  // guarded by mutex_
  std::thread thread_;
};

}  // namespace fairway::app
