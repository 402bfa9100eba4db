// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fairway::io {

/// A named stream of messages of one type.
struct McapChannel {
  std::string topic;
  std::string schema_name;  ///< channels with equal schema names have equal schemas
  std::string schema;       ///< JSON Schema; messages are JSON
};

/// Writes MCAP: chunks compressed by zstd, indexed by time and channel, with all CRCs.
///
/// It produces bytes, not files: `take` returns the bytes that are ready. A copy can be finished
/// while the original continues, which gives a complete file of an unfinished run.
class McapWriter {
 public:
  McapWriter();

  /// Adds a channel; numbers count up from 0. At most 65535 channels.
  std::uint16_t add_channel(const McapChannel& channel);

  /// @param time  The time to which the message refers [ns].
  void write(std::uint16_t channel, std::uint64_t time, std::string_view message);

  /// Writes the remaining data and the summary. Nothing can be written afterwards.
  void finish();

  /// The bytes produced since the last call.
  [[nodiscard]] std::string take();

  /// The number of bytes produced, including taken ones and the open chunk before compression.
  [[nodiscard]] std::uint64_t size() const noexcept { return written_ + chunk_.size(); }

 private:
  struct Channel {
    std::string record;  // the channel's content
    std::uint16_t schema = 0;
    std::uint32_t messages = 0;
    bool declared = false;  // whether schema and channel are already in a chunk
    std::vector<std::pair<std::uint64_t, std::uint64_t>> index;  // time, offset in the open chunk
  };

  struct ChunkIndex {
    std::uint64_t start_time = 0;
    std::uint64_t end_time = 0;
    std::uint64_t start = 0;
    std::uint64_t length = 0;
    std::map<std::uint16_t, std::uint64_t> message_indexes;  // channel, offset in the file
    std::uint64_t message_indexes_length = 0;
    std::uint64_t compressed = 0;
    std::uint64_t uncompressed = 0;
  };

  void append(std::string_view bytes);
  void close_chunk();
  [[nodiscard]] std::string statistics() const;
  [[nodiscard]] std::string summary() const;

  std::string ready_;
  std::uint64_t written_ = 0;
  std::uint32_t crc_ = 0;  // of all bytes written
  std::vector<std::string> schemas_;
  std::map<std::string, std::uint16_t> schema_ids_;
  std::vector<Channel> channels_;
  std::string chunk_;
  std::uint64_t chunk_start_time_ = 0;
  std::uint64_t chunk_end_time_ = 0;
  std::vector<ChunkIndex> chunks_;
};

}  // namespace fairway::io
