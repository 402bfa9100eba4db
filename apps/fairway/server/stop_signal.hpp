// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <csignal>
#include <functional>
#include <mutex>
#include <thread>

namespace fairway::app {

/// Takes SIGINT and SIGTERM in a thread of its own, which calls `on_signal`. Where that has not
/// ended the process within 1.5 s, because a plan or a download still runs, this ends it.
///
/// To be made before all other threads, which inherit that these signals are blocked. They stay
/// blocked: it belongs to a process that ends with it.
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
