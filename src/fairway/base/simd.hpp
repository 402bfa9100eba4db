// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

// This file defines lanes: four numbers that are processed at once.
//
// Loops over the steps of the horizon process four doubles at a time. They are templates over the
// register type: two registers of 128 bits, which every x86-64 and ARM processor has, or one of 256
// bits. Both perform the same operations in the same order, so the results are equal to the bit.

// A function can be compiled for AVX2, whatever the rest is compiled for. Every function that it
// calls with lanes must be inlined into it, because the calling convention for lanes depends on the
// processor. Functions that take or return lanes are therefore always inlined, and are not lambdas.
// Sanitizers make such functions too large, so builds with sanitizers do without AVX2.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FAIRWAY_HAS_LANES256
#define FAIRWAY_LANES [[gnu::always_inline]] inline
#else
#define FAIRWAY_LANES inline
#endif

namespace fairway {

inline constexpr std::size_t kLanes = 4;

/// Four doubles in memory. Lanes are stored register by register: a load of another width than the
/// preceding store of the same memory would stall the processor.
struct alignas(kLanes * sizeof(double)) Pack4d {
  std::array<double, kLanes> values;

  template <typename Lanes>
  FAIRWAY_LANES Pack4d& operator=(const Lanes& lanes) noexcept {
    lanes.store(values.data());
    return *this;
  }
  [[nodiscard]] double operator[](std::size_t lane) const noexcept { return values[lane]; }
  [[nodiscard]] double& operator[](std::size_t lane) noexcept { return values[lane]; }
};

/// Four doubles in registers of the compiler's vector type `Register`; `Integers` is the type of
/// their bits. A scalar converts to four equal lanes, so that formulas read as usual.
template <typename Register, typename Integers>
class BasicLanes {
 public:
  using Bits = Integers;
  static constexpr std::size_t kWidth = sizeof(Register) / sizeof(double);
  static constexpr std::size_t kRegisters = kLanes / kWidth;

  FAIRWAY_LANES BasicLanes() noexcept : BasicLanes(0.0) {}
  // NOLINTNEXTLINE(google-explicit-constructor)
  FAIRWAY_LANES BasicLanes(double value) noexcept {
    for (Register& r : registers_)
      r = Register{} + value;
  }
  // NOLINTNEXTLINE(google-explicit-constructor)
  FAIRWAY_LANES BasicLanes(const Pack4d& four) noexcept {
    load(static_cast<const double*>(__builtin_assume_aligned(four.values.data(), alignof(Pack4d))));
  }
  FAIRWAY_LANES BasicLanes(double a, double b, double c, double d) noexcept {
    if constexpr (kRegisters == 1) {
      registers_[0] = Register{a, b, c, d};
    } else {
      registers_ = {Register{a, b}, Register{c, d}};
    }
  }
  FAIRWAY_LANES void load(const double* from) noexcept {
    for (std::size_t i = 0; i < kRegisters; ++i)
      std::memcpy(&registers_[i], from + kWidth * i, sizeof(Register));
  }
  FAIRWAY_LANES void store(double* to) const noexcept {
    for (std::size_t i = 0; i < kRegisters; ++i)
      std::memcpy(to + kWidth * i, &registers_[i], sizeof(Register));
  }
  [[nodiscard]] FAIRWAY_LANES double operator[](std::size_t lane) const noexcept {
    return registers_[lane / kWidth][lane % kWidth];
  }

  // Access to the registers, and to the bits of one register.
  [[nodiscard]] FAIRWAY_LANES const Register& part(std::size_t i) const noexcept {
    return registers_[i];
  }
  [[nodiscard]] FAIRWAY_LANES Register& part(std::size_t i) noexcept { return registers_[i]; }
  [[nodiscard]] FAIRWAY_LANES static Bits bits_of(const Register& numbers) noexcept {
    Bits bits;
    std::memcpy(&bits, &numbers, sizeof bits);
    return bits;
  }
  [[nodiscard]] FAIRWAY_LANES static Register numbers_of(const Bits& bits) noexcept {
    Register numbers;
    std::memcpy(&numbers, &bits, sizeof numbers);
    return numbers;
  }

  FAIRWAY_LANES friend BasicLanes operator+(const BasicLanes& a, const BasicLanes& b) noexcept {
    BasicLanes result = a;
    for (std::size_t i = 0; i < kRegisters; ++i)
      result.registers_[i] = a.registers_[i] + b.registers_[i];
    return result;
  }
  FAIRWAY_LANES friend BasicLanes operator-(const BasicLanes& a, const BasicLanes& b) noexcept {
    BasicLanes result = a;
    for (std::size_t i = 0; i < kRegisters; ++i)
      result.registers_[i] = a.registers_[i] - b.registers_[i];
    return result;
  }
  FAIRWAY_LANES friend BasicLanes operator*(const BasicLanes& a, const BasicLanes& b) noexcept {
    BasicLanes result = a;
    for (std::size_t i = 0; i < kRegisters; ++i)
      result.registers_[i] = a.registers_[i] * b.registers_[i];
    return result;
  }
  FAIRWAY_LANES friend BasicLanes operator/(const BasicLanes& a, const BasicLanes& b) noexcept {
    BasicLanes result = a;
    for (std::size_t i = 0; i < kRegisters; ++i)
      result.registers_[i] = a.registers_[i] / b.registers_[i];
    return result;
  }
  FAIRWAY_LANES friend BasicLanes operator-(const BasicLanes& a) noexcept {
    BasicLanes result = a;
    for (Register& r : result.registers_)
      r = -r;
    return result;
  }
  FAIRWAY_LANES BasicLanes& operator+=(const BasicLanes& b) noexcept { return *this = *this + b; }
  FAIRWAY_LANES BasicLanes& operator-=(const BasicLanes& b) noexcept { return *this = *this - b; }
  FAIRWAY_LANES BasicLanes& operator*=(const BasicLanes& b) noexcept { return *this = *this * b; }

  FAIRWAY_LANES friend BasicLanes least(const BasicLanes& a, const BasicLanes& b) noexcept {
    BasicLanes result = a;
    for (std::size_t i = 0; i < kRegisters; ++i)
      result.registers_[i] = a.registers_[i] < b.registers_[i] ? a.registers_[i] : b.registers_[i];
    return result;
  }
  FAIRWAY_LANES friend BasicLanes greatest(const BasicLanes& a, const BasicLanes& b) noexcept {
    BasicLanes result = a;
    for (std::size_t i = 0; i < kRegisters; ++i)
      result.registers_[i] = a.registers_[i] > b.registers_[i] ? a.registers_[i] : b.registers_[i];
    return result;
  }
  /// Selects `yes` in the lanes where a > b, and `no` in the others.
  FAIRWAY_LANES friend BasicLanes where_greater(const BasicLanes& a,
                                                const BasicLanes& b,
                                                const BasicLanes& yes,
                                                const BasicLanes& no) noexcept {
    BasicLanes result = yes;
    for (std::size_t i = 0; i < kRegisters; ++i)
      result.registers_[i] =
          a.registers_[i] > b.registers_[i] ? yes.registers_[i] : no.registers_[i];
    return result;
  }
  FAIRWAY_LANES friend BasicLanes magnitude(const BasicLanes& a) noexcept {
    return greatest(a, -a);
  }

  FAIRWAY_LANES friend double sum_of(const BasicLanes& a) noexcept {
    return (a[0] + a[1]) + (a[2] + a[3]);
  }
  FAIRWAY_LANES friend double least_of(const BasicLanes& a) noexcept {
    const double first = a[0] < a[1] ? a[0] : a[1];
    const double last = a[2] < a[3] ? a[2] : a[3];
    return first < last ? first : last;
  }
  FAIRWAY_LANES friend double greatest_of(const BasicLanes& a) noexcept { return -least_of(-a); }

 private:
  std::array<Register, kRegisters> registers_;
};

using Register128 [[gnu::vector_size(16)]] = double;
using Integers128 [[gnu::vector_size(16)]] = std::uint64_t;
using Register256 [[gnu::vector_size(32)]] = double;
using Integers256 [[gnu::vector_size(32)]] = std::uint64_t;
using Lanes128 = BasicLanes<Register128, Integers128>;
using Lanes256 = BasicLanes<Register256, Integers256>;

/// Loads entries k to k + 3 of an array. @pre these entries exist.
template <typename Lanes, std::size_t n>
FAIRWAY_LANES Lanes lanes(const std::array<double, n>& array, std::size_t k) noexcept {
  Lanes value;
  value.load(array.data() + k);
  return value;
}
template <typename Lanes, std::size_t n>
FAIRWAY_LANES void put(std::array<double, n>& array, std::size_t k, const Lanes& value) noexcept {
  value.store(array.data() + k);
}

/// The transpose of a 4 x 4 matrix: `first` holds the first lane of each argument, and so on.
template <typename Lanes>
struct Transposed {
  Lanes first, second, third, fourth;
};
template <typename Lanes>
FAIRWAY_LANES Transposed<Lanes> transposed(const Lanes& a,
                                           const Lanes& b,
                                           const Lanes& c,
                                           const Lanes& d) noexcept {
  Transposed<Lanes> t;
  if constexpr (Lanes::kRegisters == 1) {
    const auto ab02 = __builtin_shufflevector(a.part(0), b.part(0), 0, 4, 2, 6);
    const auto ab13 = __builtin_shufflevector(a.part(0), b.part(0), 1, 5, 3, 7);
    const auto cd02 = __builtin_shufflevector(c.part(0), d.part(0), 0, 4, 2, 6);
    const auto cd13 = __builtin_shufflevector(c.part(0), d.part(0), 1, 5, 3, 7);
    t.first.part(0) = __builtin_shufflevector(ab02, cd02, 0, 1, 4, 5);
    t.second.part(0) = __builtin_shufflevector(ab13, cd13, 0, 1, 4, 5);
    t.third.part(0) = __builtin_shufflevector(ab02, cd02, 2, 3, 6, 7);
    t.fourth.part(0) = __builtin_shufflevector(ab13, cd13, 2, 3, 6, 7);
  } else {
    for (std::size_t i = 0; i < 2; ++i) {
      Lanes& even = i == 0 ? t.first : t.third;
      Lanes& odd = i == 0 ? t.second : t.fourth;
      even.part(0) = __builtin_shufflevector(a.part(i), b.part(i), 0, 2);
      even.part(1) = __builtin_shufflevector(c.part(i), d.part(i), 0, 2);
      odd.part(0) = __builtin_shufflevector(a.part(i), b.part(i), 1, 3);
      odd.part(1) = __builtin_shufflevector(c.part(i), d.part(i), 1, 3);
    }
  }
  return t;
}

/// The vector types of GCC and Clang: four floats, the mask of a comparison, and bits to accumulate
/// masks in.
///
/// A comparison sets all bits of a lane where it is true. Arithmetic, comparison and selection
/// (`mask ? a : b`) work lane by lane; a scalar is broadcast to all lanes.
using Pack4f = float __attribute__((vector_size(16)));
using Mask4 = int __attribute__((vector_size(16)));
using Bits4 = unsigned __attribute__((vector_size(16)));

[[nodiscard]] inline Pack4f min(Pack4f a, Pack4f b) noexcept { return a < b ? a : b; }
[[nodiscard]] inline Pack4f max(Pack4f a, Pack4f b) noexcept { return a > b ? a : b; }

/// Returns the same number in every lane.
[[nodiscard]] inline Pack4f four(float a) noexcept { return Pack4f{a, a, a, a}; }

/// Returns -a where the mask is set, and a elsewhere. @pre a is not negative.
[[nodiscard]] inline Pack4f with_sign_of(Mask4 mask, Pack4f a) noexcept {
  constexpr int kSign = std::numeric_limits<int>::min();
  return std::bit_cast<Pack4f>(std::bit_cast<Mask4>(a) | (mask & kSign));
}

/// Loads four numbers from `from`, which need not be aligned.
[[nodiscard]] inline Pack4f load4(const float* from) noexcept {
  Pack4f result;
  std::memcpy(&result, from, sizeof result);
  return result;
}
inline void store4(Pack4f a, float* to) noexcept { std::memcpy(to, &a, sizeof a); }

}  // namespace fairway
