// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
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

inline constexpr int kMaxHalvings = 15;  ///< of the length of a step

/// Decides which lengths of one step are accepted.
class LineSearch {
 public:
  /// `slope` is the derivative of the barrier function along the step, Eq. (S16).
  LineSearch(const Progress& before, double slope) noexcept : before_(before), slope_(slope) {}

  /// Returns whether the point at `length` is accepted; the filter then stores what it must. If the
  /// barrier function decreases fast compared with the residual, it must decrease as predicted.
  /// Otherwise one of the two must improve.
  [[nodiscard]] bool accepts(Progress after, double length, Filter& filter) const noexcept {
    constexpr double kSufficient = 1e-4;  // share of the predicted decrease that is required
    constexpr double kRounding = 1e-12;   // of the barrier function, relative
    after.barrier -= kRounding * std::abs(before_.barrier);
    if (!std::isfinite(after.barrier + after.residual) || !filter.accepts(after)) return false;
    const bool falls = slope_ < 0.0 && (before_.residual <= kNoResidual ||
                                        length * slope_ * slope_ > before_.residual);
    const bool accepted = falls ? after.barrier <= before_.barrier + kSufficient * length * slope_
                                : Filter::improves(after, before_);
    if (accepted && !falls) filter.add(before_);
    return accepted;
  }

 private:
  Progress before_;
  double slope_;
};

}  // namespace fairway::interior_point
