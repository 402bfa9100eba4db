// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

namespace fairway {

/// A seeded random number generator that gives equal numbers with every standard library.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [low, high).
  [[nodiscard]] double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1.0p-53);
  }

  /// Normal with this standard deviation and mean 0.
  [[nodiscard]] double normal(double sigma);

 private:
  std::mt19937_64 engine_;
};

}  // namespace fairway
