// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>

namespace fairway::nav2 {

/// Keeps messages until the transforms for their time have arrived, so that no callback waits.
/// Not thread-safe.
template <typename Message>
class ScanQueue {
 public:
  static constexpr std::size_t kMost = 16;  ///< kept messages; the oldest are dropped
  static constexpr double kOldest = 1.0;    ///< age at which a message is dropped [s]

  /// Adds a message. @param time  Of its measurement [s].
  void add(double time, Message message) {
    if (waiting_.size() == kMost) {
      waiting_.pop_front();
      ++dropped_;
    }
    waiting_.emplace_back(time, std::move(message));
  }

  /// Uses the messages in their order as far as possible: `use(message)` returns whether its
  /// transforms were there. A message that cannot be used yet keeps its place; later ones wait
  /// behind it.
  template <typename Use>
  void drain(double now, Use&& use) {
    while (!waiting_.empty()) {
      if (std::abs(now - waiting_.front().first) > kOldest) {
        ++dropped_;
      } else if (!use(std::as_const(waiting_.front().second))) {
        return;
      }
      waiting_.pop_front();
    }
  }

  void clear() noexcept { waiting_.clear(); }
  [[nodiscard]] std::size_t size() const noexcept { return waiting_.size(); }
  /// Messages that were dropped without use since the start.
  [[nodiscard]] std::size_t dropped() const noexcept { return dropped_; }

 private:
  std::deque<std::pair<double, Message>> waiting_;
  std::size_t dropped_ = 0;
};

}  // namespace fairway::nav2
