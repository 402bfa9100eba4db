// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fairway::io::mcap {

// The container format MCAP (mcap.dev/spec): records of an opcode, a length and fields, with
// little-endian numbers. Only the part that Fairway writes and reads is here.

inline constexpr std::string_view kMagic = "\x89MCAP0\r\n";

enum class Opcode : std::uint8_t {
  Header = 0x01,
  Footer = 0x02,
  Schema = 0x03,
  Channel = 0x04,
  Message = 0x05,
  Chunk = 0x06,
  MessageIndex = 0x07,
  ChunkIndex = 0x08,
  Statistics = 0x0B,
  SummaryOffset = 0x0E,
  DataEnd = 0x0F,
};

/// Appends MCAP's numbers and strings to a buffer.
class ByteWriter {
 public:
  explicit ByteWriter(std::string& bytes) : bytes_(&bytes) {}

  template <typename Unsigned>
  void number(Unsigned value) {
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
      bytes_->push_back(static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xFFU));
  }

  /// Appends a length of 32 bits, then the text.
  void text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size()));
    bytes_->append(value);
  }

 private:
  std::string* bytes_;
};

/// Reads values from the front of a buffer. When the buffer ends too early, `ok` becomes false and
/// stays false, and every further value is 0 or empty.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  [[nodiscard]] bool ok() const noexcept { return ok_; }
  [[nodiscard]] std::string_view rest() const noexcept { return rest_; }

  template <typename Unsigned>
  [[nodiscard]] Unsigned number() noexcept {
    const std::string_view field = bytes(sizeof(Unsigned));
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < field.size(); ++i)
      value |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(field[i])) << (8 * i);
    return static_cast<Unsigned>(value);
  }

  [[nodiscard]] std::string_view text() noexcept { return bytes(number<std::uint32_t>()); }

  [[nodiscard]] std::string_view bytes(std::uint64_t count) noexcept {
    if (!ok_ || count > rest_.size()) {
      ok_ = false;
      return {};
    }
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

 private:
  std::string_view rest_;
  bool ok_ = true;
};

/// CRC-32 as in zlib; `crc` continues an earlier one.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes, std::uint32_t crc = 0) noexcept;

/// Appends one record: opcode, length, content.
void append_record(std::string& bytes, Opcode opcode, std::string_view content);

/// Compresses content with zstd.
[[nodiscard]] std::string compress(std::string_view content);

/// Decompresses to `size` bytes; none if `compressed` is damaged or has another size.
[[nodiscard]] std::optional<std::string> decompress(std::string_view compressed,
                                                    std::uint64_t size);

}  // namespace fairway::io::mcap
