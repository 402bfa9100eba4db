// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace fairway::interior_point {

inline constexpr double kNoResidual = 1e-9;  ///< residuals below this count as 0

/// The two quantities that a step should reduce: the barrier function and the residual of the
/// constraints.
struct Progress {
  double barrier = 0.0;   ///< phi of Eq. (S15)
  double residual = 0.0;  ///< theta, the sum of |c + e - s|
};

/// The filter of a line search: pairs on which later iterates must improve in one of the two. It
/// keeps the iteration on one barrier problem from cycling, and needs no penalty parameter.
class Filter {
 public:
  static constexpr double kMargin = 1e-5;  ///< least relative decrease of the residual

  void clear() noexcept { count_ = 0; }

  /// Returns whether `to` improves enough on `from` in one of the two.
  [[nodiscard]] static bool improves(const Progress& to, const Progress& from) noexcept {
    return to.residual <= (1.0 - kMargin) * from.residual ||
           to.barrier <= from.barrier - kMargin * from.residual;
  }

  [[nodiscard]] bool accepts(const Progress& progress) const noexcept {
    return std::all_of(entries_.begin(), entries_.begin() + count_,
                       [&](const Progress& entry) { return improves(progress, entry); });
  }

  /// Adds an entry; a full filter drops its oldest one.
  void add(const Progress& progress) noexcept {
    if (count_ == kCapacity) std::move(entries_.begin() + 1, entries_.end(), entries_.begin());
    count_ = std::min(count_ + 1, kCapacity);
    entries_[static_cast<std::size_t>(count_ - 1)] = progress;
  }

 private:
  static constexpr int kCapacity = 32;
  std::array<Progress, kCapacity> entries_;
  int count_ = 0;
};

}  // namespace fairway::interior_point
