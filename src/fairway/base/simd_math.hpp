// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "fairway/base/simd.hpp"

// Sine, cosine and logarithm of four numbers at once. The functions of the standard library differ
// in the last bit between processors; these do not.

namespace fairway {

// Selects `even` or `odd` by the last bit of `quarter`. The result is negated if the bit before the
// last of quarter + ahead is set.
template <typename Lanes>
FAIRWAY_LANES Lanes turned_by_quarters(const Lanes& quarter,
                                       std::uint64_t ahead,
                                       const Lanes& even,
                                       const Lanes& odd) noexcept {
  constexpr int kSignAboveSecond = 62;
  Lanes result;
  for (std::size_t i = 0; i < Lanes::kRegisters; ++i) {
    const auto bits = Lanes::bits_of(quarter.part(i));
    const auto is_odd = -(bits & 1);
    const auto chosen =
        (Lanes::bits_of(odd.part(i)) & is_odd) | (Lanes::bits_of(even.part(i)) & ~is_odd);
    result.part(i) = Lanes::numbers_of(chosen ^ (((bits + ahead) & 2) << kSignAboveSecond));
  }
  return result;
}

template <typename Lanes>
struct Direction {
  Lanes cosine, sine;
};

inline constexpr double kMostHeading = 1e6;  ///< greatest heading of the polynomials [rad]

/// Computes the directions of four headings, with an error below 2e-16.
/// @pre |heading| <= kMostHeading
template <typename Lanes>
FAIRWAY_LANES Direction<Lanes> direction_within(const Lanes& heading) noexcept {
  // heading = quarter * pi / 2 + a with |a| <= pi / 4. Adding kRounding rounds a double to an
  // integer, which its last bits then hold; pi / 2 is split so that products with quarters are
  // exact.
  constexpr double kRounding = 0x1.8p+52;
  constexpr double kQuarterHigh = 0x1.921fb544p+0;
  constexpr double kQuarterLow = 0x1.0b4611a626331p-34;
  const Lanes shifted = heading * (2.0 / std::numbers::pi) + kRounding;
  const Lanes quarter = shifted - kRounding;
  const Lanes a = (heading - quarter * kQuarterHigh) - quarter * kQuarterLow;
  // Taylor series; the first omitted terms are below 1e-16.
  const Lanes q = a * a;
  const Lanes sine =
      a +
      a * q *
          (-1.0 / 6 +
           q * (1.0 / 120 +
                q * (-1.0 / 5040 + q * (1.0 / 362880 + q * (-1.0 / 39916800 +
                                                            q * (1.0 / 6227020800.0 +
                                                                 q * (-1.0 / 1307674368000.0)))))));
  const Lanes cosine =
      1.0 - 0.5 * q +
      q * q *
          (1.0 / 24 + q * (-1.0 / 720 +
                           q * (1.0 / 40320 +
                                q * (-1.0 / 3628800 +
                                     q * (1.0 / 479001600 + q * (-1.0 / 87178291200.0 +
                                                                 q * (1.0 / 20922789888000.0)))))));
  // The result by quarter: (c, s), (-s, c), (-c, -s), (s, -c).
  return {.cosine = turned_by_quarters(shifted, 1, cosine, sine),
          .sine = turned_by_quarters(shifted, 0, sine, cosine)};
}

/// Computes the directions of four headings. The error is below 2e-16 up to 1e6 rad; beyond that
/// the functions of the standard library are used.
template <typename Lanes>
FAIRWAY_LANES Direction<Lanes> direction_of(const Lanes& heading) noexcept {
  if (!(greatest_of(magnitude(heading)) <= kMostHeading)) {
    return {.cosine = Lanes(std::cos(heading[0]), std::cos(heading[1]), std::cos(heading[2]),
                            std::cos(heading[3])),
            .sine = Lanes(std::sin(heading[0]), std::sin(heading[1]), std::sin(heading[2]),
                          std::sin(heading[3]))};
  }
  return direction_within(heading);
}

/// Computes natural logarithms between 1 / sqrt(2) and sqrt(2), with an error below 1e-15.
template <typename Number>
[[nodiscard]] FAIRWAY_LANES Number log_near_one(const Number& value) noexcept {
  // log value = 2 artanh t; the first omitted term is below 1e-18.
  const Number t = (value - 1.0) / (value + 1.0);
  const Number q = t * t;
  const Number series =
      1.0 + q * (1.0 / 3 +
                 q * (1.0 / 5 +
                      q * (1.0 / 7 +
                           q * (1.0 / 9 +
                                q * (1.0 / 11 +
                                     q * (1.0 / 13 +
                                          q * (1.0 / 15 +
                                               q * (1.0 / 17 + q * (1.0 / 19 + q / 21.0)))))))));
  return 2.0 * t * series;
}

/// Computes the natural logarithm of a number in [1, 16), with an error below 1e-15.
[[nodiscard]] inline double log_below_16(double value) noexcept {
  double doublings = 0.0;
  while (value > std::numbers::sqrt2) {
    value *= 0.5;
    doublings += 1.0;
  }
  return log_near_one(value) + std::numbers::ln2 * doublings;
}

/// Sums the logarithms of many positive numbers with one call of a logarithm. It multiplies the
/// mantissas and adds the exponents separately. @pre each number is between 1e-100 and 1e100.
template <typename Lanes>
class LogSum {
 public:
  FAIRWAY_LANES void add(const Lanes& factor) noexcept {
    constexpr std::uint64_t kMantissa = 0x000fffffffffffff;
    constexpr std::uint64_t kOne = 0x3ff0000000000000;
    constexpr int kMantissaBits = 52;
    mantissa_ *= factor;
    ++count_;
    for (std::size_t i = 0; i < Lanes::kRegisters; ++i) {
      const auto bits = Lanes::bits_of(mantissa_.part(i));
      exponents_[i] += bits >> kMantissaBits;
      mantissa_.part(i) = Lanes::numbers_of((bits & kMantissa) | kOne);
    }
  }

  [[nodiscard]] FAIRWAY_LANES double value() const noexcept {
    constexpr std::uint64_t kBias = 1023;
    std::uint64_t exponent = 0;
    for (const typename Lanes::Bits& exponents : exponents_) {
      for (std::size_t i = 0; i < Lanes::kWidth; ++i)
        exponent += exponents[i];
    }
    const auto signed_exponent = static_cast<std::int64_t>(exponent - kLanes * kBias * count_);
    const double rest = (mantissa_[0] * mantissa_[1]) * (mantissa_[2] * mantissa_[3]);
    return log_below_16(rest) + std::numbers::ln2 * static_cast<double>(signed_exponent);
  }

  /// Returns the sum of each lane.
  [[nodiscard]] FAIRWAY_LANES Lanes values() const noexcept {
    constexpr std::uint64_t kBias = 1023;
    Pack4d doublings;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const std::uint64_t exponent = exponents_[lane / Lanes::kWidth][lane % Lanes::kWidth];
      doublings[lane] = static_cast<double>(static_cast<std::int64_t>(exponent - kBias * count_));
    }
    const Lanes root = std::numbers::sqrt2;
    const Lanes near_one = where_greater(mantissa_, root, 0.5 * mantissa_, mantissa_);
    const Lanes halved = where_greater(mantissa_, root, Lanes(1.0), Lanes(0.0));
    return log_near_one(near_one) + std::numbers::ln2 * (doublings + halved);
  }

 private:
  Lanes mantissa_{1.0};
  std::array<typename Lanes::Bits, Lanes::kRegisters> exponents_{};
  std::uint64_t count_ = 0;
};

}  // namespace fairway
