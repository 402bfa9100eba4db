// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fairway::io {

/// A named stream of messages of one kind.
struct McapChannel {
  std::string topic;
  std::string schema_name;  ///< channels of one schema name have the same schema
  std::string schema;       ///< JSON Schema; messages are JSON
};

/// Writes MCAP: chunks compressed by zstd, indexed by time and channel, every CRC computed.
///
/// It makes bytes, not files: `take` hands over what has become ready. A copy can be finished while
/// the original goes on, which gives a whole file of a run that has not ended.
class McapWriter {
 public:
  McapWriter();

  /// Numbers count up from 0. At most 65535 channels.
  std::uint16_t add_channel(const McapChannel& channel);

  /// @param time  When it was true [ns].
  void write(std::uint16_t channel, std::uint64_t time, std::string_view message);

  /// Writes what is left, and the summary. Nothing can be written afterwards.
  void finish();

  /// The bytes made since the last call.
  [[nodiscard]] std::string take();

  /// Bytes made so far, taken or not, and those of the open chunk before compression.
  [[nodiscard]] std::uint64_t size() const noexcept { return written_ + chunk_.size(); }

 private:
  struct Channel {
    std::string record;  // the channel's content
    std::uint16_t schema = 0;
    std::uint32_t messages = 0;
    bool declared = false;  // whether schema and channel stand in a chunk already
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
  std::uint32_t crc_ = 0;  // of all bytes so far
  std::vector<std::string> schemas_;
  std::map<std::string, std::uint16_t> schema_ids_;
  std::vector<Channel> channels_;
  std::string chunk_;
  std::uint64_t chunk_start_time_ = 0;
  std::uint64_t chunk_end_time_ = 0;
  std::vector<ChunkIndex> chunks_;
};

}  // namespace fairway::io
