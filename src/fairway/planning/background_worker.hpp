// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace fairway {

/// Runs one job at a time in a thread of its own, which starts with the first job.
///
/// All functions are called by the thread that owns the worker; only `wait` and the destructor
/// block. Everything that the job reads and writes belongs to the job from `start` until `finished`
/// returns true.
class BackgroundWorker {
 public:
  BackgroundWorker() = default;
  BackgroundWorker(const BackgroundWorker&) = delete;
  BackgroundWorker& operator=(const BackgroundWorker&) = delete;
  ~BackgroundWorker();  ///< waits for the job

  /// Starts a job, which must not throw. @pre idle.
  void start(std::function<void()> job);

  [[nodiscard]] bool idle() const noexcept { return state_.load() == State::Idle; }
  [[nodiscard]] bool finished() const noexcept { return state_.load() == State::Finished; }

  /// Makes a finished worker idle again. @pre finished.
  void collect() noexcept;

  /// Waits until the job, if there is one, is finished.
  void wait() const noexcept;

 private:
  enum class State : int { Idle, Running, Finished, Ending };

  void run();

  std::function<void()> job_;
  std::atomic<State> state_{State::Idle};
  std::thread thread_;
};

}  // namespace fairway
