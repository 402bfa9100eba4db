// SPDX-License-Identifier: Apache-2.0
#pragma once

// The part of zlib's interface that fairway::io uses, for the browser, where zlib is not packaged.
// compress2 writes zlib's format without compressing; browsers read it all the same.
using Bytef = unsigned char;
using uInt = unsigned int;
using uLong = unsigned long;
using uLongf = unsigned long;

inline constexpr int Z_OK = 0;
inline constexpr int Z_BUF_ERROR = -5;
inline constexpr int Z_BEST_COMPRESSION = 9;

uLong crc32(uLong crc, const Bytef* bytes, uInt size);
uLong compressBound(uLong size);
int compress2(Bytef* to, uLongf* to_size, const Bytef* from, uLong size, int level);
