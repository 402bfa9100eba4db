// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "fairway/base/error.hpp"

namespace fairway::io {

/// One message of a file.
struct McapMessage {
  std::string_view topic;
  std::string_view schema_name;
  std::uint32_t sequence = 0;  ///< number of the message in its channel, from 0 on
  std::uint64_t time = 0;      ///< [ns]
  std::string_view content;
};

/// Reads the messages of an MCAP file in the order in which they were written, and checks all CRCs.
/// Chunks may be uncompressed or compressed by zstd.
///
/// Stops at the first error, its own or one that `on_message` returns. A file without a summary
/// (its writer was killed) is read to its end, and then gives an error. `name` is the file in
/// messages.
[[nodiscard]] Expected<void> read_mcap(
    std::string_view bytes,
    const std::string& name,
    const std::function<Expected<void>(const McapMessage&)>& on_message);

}  // namespace fairway::io
