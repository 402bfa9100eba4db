// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/web_report/report.hpp"

#include <zlib.h>

#include <new>

#include "fairway/base/contract.hpp"
#include "fairway/io/base64.hpp"
#include "fairway/io/web_report/viewer_page.hpp"

namespace fairway::io {

namespace {

// The place of the run in the page.
constexpr std::string_view kPlace = "<script id=\"run\" type=\"text/plain\">";

// Compresses in zlib's format, which browsers decompress.
std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const int result =
      compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
  // With this bound, compression can fail only for lack of memory.
  if (result != Z_OK) throw std::bad_alloc();
  packed.resize(size);
  return packed;
}

}  // namespace

std::string report_page(std::string_view stream) {
  std::string page(viewer_page());
  const std::size_t place = page.find(kPlace);
  FAIRWAY_ENSURES(place != std::string::npos);
  return page.insert(place + kPlace.size(), to_base64(deflated(stream)));
}

std::string Report::page() { return report_page(stream_.take()); }

}  // namespace fairway::io
