// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as an MCAP file: every message lies within them, or one line refuses them.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "fairway/io/mcap/mcap_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(data, data + size);
  std::size_t sum = 0;
  const auto read =
      fairway::io::read_mcap(bytes, "m.mcap", [&](const fairway::io::McapMessage& message) {
        for (const char c : message.content)
          sum += static_cast<std::size_t>(c == '{');
        sum += message.topic.size() + message.schema_name.size();
        return fairway::Expected<void>();
      });
  if (!read && read.error().message.find('\n') != std::string::npos) std::abort();
  return 0;
}
