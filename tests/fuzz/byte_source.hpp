// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace fairway::test {

/// Reads a fuzzer's bytes as numbers, from front to back. After their end a fixed sequence
/// continues, which is not constant.
class ByteSource {
 public:
  ByteSource(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  /// Whether some of the fuzzer's bytes are left.
  [[nodiscard]] bool left() const { return position_ < size_; }

  /// Returns any double.
  double number() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i)
      bits = bits << 8U | byte();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  double usual(double low, double high) {
    const unsigned share = byte() << 8U | byte();
    return low + (high - low) * share / 65535.0;
  }

  /// Returns an integer from `low` to `high`, out of at most 65536.
  int integer(int low, int high) {
    const unsigned any = high - low < 256 ? byte() : byte() << 8U | byte();
    return low + static_cast<int>(any) % (high - low + 1);
  }

  bool chance(double probability) { return byte() < 255.0 * probability; }

 private:
  unsigned byte() {
    const std::size_t at = position_++;
    return at < size_ ? data_[at] : static_cast<unsigned>(at * 2654435761U >> 7U & 0xffU);
  }

  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t position_ = 0;
};

}  // namespace fairway::test
