// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as a message of a live page's client: a command or a map.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "server/live_command.hpp"
#include "server/uploads/uploaded_map.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  static_cast<void>(fairway::app::parse_command(text));
  const auto map = fairway::app::read_uploaded_map(text);
  if (map && (map->name.empty() || map->map.frame().width < 1)) std::abort();
  return 0;
}
