// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

// The part of zstd's interface that fairway::io uses, for the browser, where zstd is not packaged.
// ZSTD_compress writes a valid frame without compressing; nothing is decompressed here.
inline constexpr unsigned long long ZSTD_CONTENTSIZE_UNKNOWN = ~0ULL;
inline constexpr unsigned long long ZSTD_CONTENTSIZE_ERROR = ~1ULL;

std::size_t ZSTD_compressBound(std::size_t size);
std::size_t ZSTD_compress(void* to, std::size_t capacity, const void* from, std::size_t size, int level);
unsigned ZSTD_isError(std::size_t result);
const char* ZSTD_getErrorName(std::size_t result);
unsigned long long ZSTD_getFrameContentSize(const void* from, std::size_t size);
std::size_t ZSTD_decompress(void* to, std::size_t capacity, const void* from, std::size_t size);
