// SPDX-License-Identifier: Apache-2.0
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace {

constexpr std::size_t kError = ~std::size_t{0};
constexpr std::size_t kDeflateBlock = 65535;     // RFC 1951, 3.2.4
constexpr std::size_t kZstdBlock = 128U << 10U;  // RFC 8878, 3.1.1.2.4
constexpr std::size_t kZstdHeader = 4 + 1 + 4;   // magic, descriptor, size of the content
constexpr std::size_t kZstdBlockHeader = 3;

void put(unsigned char*& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i)
    *out++ = static_cast<unsigned char>(value >> (8 * i));
}

std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    table[i] = i;
    for (int bit = 0; bit < 8; ++bit)
      table[i] = table[i] >> 1U ^ ((table[i] & 1U) != 0U ? 0xEDB88320U : 0U);
  }
  return table;
}

std::uint32_t adler32(const Bytef* bytes, std::size_t size) {
  constexpr std::uint32_t kModulus = 65521;
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (std::size_t i = 0; i < size; ++i) {
    a = (a + bytes[i]) % kModulus;
    b = (b + a) % kModulus;
  }
  return b << 16U | a;
}

}  // namespace

uLong crc32(uLong crc, const Bytef* bytes, uInt size) {
  static const std::array<std::uint32_t, 256> table = crc_table();
  auto sum = ~static_cast<std::uint32_t>(crc);
  for (uInt i = 0; i < size; ++i)
    sum = sum >> 8U ^ table[(sum ^ bytes[i]) & 0xFFU];
  return ~sum;
}

uLong compressBound(uLong size) { return size + 5 * (size / kDeflateBlock + 1) + 6; }

int compress2(Bytef* to, uLongf* to_size, const Bytef* from, uLong size, int /*level*/) {
  if (*to_size < compressBound(size)) return Z_BUF_ERROR;
  Bytef* out = to;
  put(out, 0x0178, 2);  // deflate, no dictionary
  std::size_t done = 0;
  do {
    const std::size_t part = std::min<std::size_t>(kDeflateBlock, size - done);
    put(out, done + part == size ? 1 : 0, 1);
    put(out, part, 2);
    put(out, ~part, 2);
    std::memcpy(out, from + done, part);
    out += part;
    done += part;
  } while (done < size);
  const std::uint32_t sum = adler32(from, size);
  for (int shift = 24; shift >= 0; shift -= 8)
    put(out, sum >> shift & 0xFFU, 1);
  *to_size = static_cast<uLongf>(out - to);
  return Z_OK;
}

std::size_t ZSTD_compressBound(std::size_t size) {
  return kZstdHeader + size + kZstdBlockHeader * (size / kZstdBlock + 1);
}

std::size_t ZSTD_compress(
    void* to, std::size_t capacity, const void* from, std::size_t size, int /*level*/) {
  if (capacity < ZSTD_compressBound(size)) return kError;
  auto* out = static_cast<unsigned char*>(to);
  put(out, 0xFD2FB528, 4);
  put(out, 0xA0, 1);  // one segment; its size has four bytes
  put(out, size, 4);
  std::size_t done = 0;
  do {
    const std::size_t part = std::min(kZstdBlock, size - done);
    put(out, part << 3U | (done + part == size ? 1U : 0U), 3);  // a raw block
    std::memcpy(out, static_cast<const char*>(from) + done, part);
    out += part;
    done += part;
  } while (done < size);
  return static_cast<std::size_t>(out - static_cast<unsigned char*>(to));
}

unsigned ZSTD_isError(std::size_t result) { return result == kError ? 1U : 0U; }
const char* ZSTD_getErrorName(std::size_t /*result*/) { return "not supported in the browser"; }
unsigned long long ZSTD_getFrameContentSize(const void* /*from*/, std::size_t /*size*/) {
  return ZSTD_CONTENTSIZE_ERROR;
}
std::size_t ZSTD_decompress(void* /*to*/,
                            std::size_t /*capacity*/,
                            const void* /*from*/,
                            std::size_t /*size*/) {
  return kError;
}
