// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace fairway::test {

/// Counts calls of malloc, calloc, realloc and friends between its construction and `count()`, in
/// this thread. Hooks malloc itself: Eigen allocates past operator new.
///
/// Needs allocation_guard.cpp in the program. Under sanitizers, which own malloc, it counts
/// nothing: `available` is false and the test has to skip.
class AllocationGuard {
 public:
  AllocationGuard() noexcept;

  /// Heap calls since construction.
  [[nodiscard]] std::size_t count() const noexcept;

  static const bool available;

 private:
  std::size_t before_;
};

}  // namespace fairway::test
