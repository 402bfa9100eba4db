// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstring>
#include <limits>

namespace fairway {

/// Four floats that one instruction works on, the outcome of comparing them (all bits set where it
/// holds), and bits to collect such outcomes in. The vector types that GCC and Clang share;
/// arithmetic, comparison and selection (`mask ? a : b`) work lane by lane, numbers stand for four
/// equal ones.
using Float4 = float __attribute__((vector_size(16)));
using Mask4 = int __attribute__((vector_size(16)));
using Bits4 = unsigned __attribute__((vector_size(16)));

[[nodiscard]] inline Float4 min(Float4 a, Float4 b) noexcept { return a < b ? a : b; }
[[nodiscard]] inline Float4 max(Float4 a, Float4 b) noexcept { return a > b ? a : b; }

/// The same number in every lane.
[[nodiscard]] inline Float4 four(float a) noexcept { return Float4{a, a, a, a}; }

/// -a where the mask holds, a elsewhere. @pre a is not negative.
[[nodiscard]] inline Float4 with_sign_of(Mask4 mask, Float4 a) noexcept {
  constexpr int kSign = std::numeric_limits<int>::min();
  return std::bit_cast<Float4>(std::bit_cast<Mask4>(a) | (mask & kSign));
}

/// The four numbers from an address on, which need not be aligned.
[[nodiscard]] inline Float4 load4(const float* from) noexcept {
  Float4 result;
  std::memcpy(&result, from, sizeof result);
  return result;
}
inline void store4(Float4 a, float* to) noexcept { std::memcpy(to, &a, sizeof a); }

}  // namespace fairway
