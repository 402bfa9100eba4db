// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

namespace fairway {

/// Uniform random numbers, to the bit those of numpy's `random.seed(seed)` and `random.random()`.
class UniformRandom {
 public:
  explicit UniformRandom(std::uint32_t seed) : generator_(seed) {}

  /// Draws a number from 0 to 1, excluding 1, with 53 random bits.
  [[nodiscard]] double unit() {
    constexpr double kLowBits = 67108864.0;         // 2^26
    constexpr double kValues = 9007199254740992.0;  // 2^53
    const auto high = static_cast<double>(generator_() >> 5U);
    const auto low = static_cast<double>(generator_() >> 6U);
    return (high * kLowBits + low) / kValues;
  }

  /// Draws a number from `low` to `high`.
  [[nodiscard]] double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::mt19937 generator_;
};

}  // namespace fairway
