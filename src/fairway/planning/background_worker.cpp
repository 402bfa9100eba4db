// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/background_worker.hpp"

#include <utility>

#include "fairway/base/contract.hpp"

namespace fairway {

BackgroundWorker::~BackgroundWorker() {
  if (!thread_.joinable()) return;
  wait();
  state_.store(State::Ending);
  state_.notify_all();
  thread_.join();
}

void BackgroundWorker::start(std::function<void()> job) {
  FAIRWAY_EXPECTS(idle());
  job_ = std::move(job);
#ifdef FAIRWAY_WITHOUT_THREADS  // in a browser: the job is done at once
  job_();
  state_.store(State::Finished);
#else
  state_.store(State::Running);
  state_.notify_all();
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
#endif
}

void BackgroundWorker::collect() noexcept {
  FAIRWAY_EXPECTS(finished());
  state_.store(State::Idle);
}

void BackgroundWorker::wait() const noexcept { state_.wait(State::Running); }

void BackgroundWorker::run() {
  while (true) {
    State now = state_.load();
    while (now == State::Idle || now == State::Finished) {
      state_.wait(now);
      now = state_.load();
    }
    if (now == State::Ending) return;
    job_();
    state_.store(State::Finished);
    state_.notify_all();
  }
}

}  // namespace fairway
