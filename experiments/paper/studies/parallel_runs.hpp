// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/core.h>

#include "experiments/paper/studies/study_options.hpp"

namespace fairway::reproduction {

/// Runs `task(0)` to `task(count - 1)` in `options.threads` threads, and returns their results in
/// order. The tasks must not share state that they change; then the result does not depend on the
/// number of threads.
template <typename Task>
auto run_all(std::size_t count,
             const StudyOptions& options,
             const std::string& what,
             const Task& task) {
  using Result = decltype(task(std::size_t{0}));
  std::vector<std::optional<Result>> slots(count);
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        slots[i] = task(i);
        const std::lock_guard lock(mutex);
        if (options.progress) options.progress(fmt::format("{}: {} of {}", what, ++done, count));
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < options.threads; ++i)
      others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  std::vector<Result> results;
  results.reserve(count);
  for (std::optional<Result>& slot : slots)
    results.push_back(std::move(*slot));
  return results;
}

}  // namespace fairway::reproduction
