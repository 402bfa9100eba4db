// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace fairway::test {

/// Counts calls of malloc, calloc, realloc and similar functions between its construction and
/// `count()`, in this thread. It hooks malloc itself, because Eigen does not use operator new.
///
/// The program must link allocation_guard.cpp. Under sanitizers, which replace malloc, it counts
/// nothing: `available` is false, and the test must skip.
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
