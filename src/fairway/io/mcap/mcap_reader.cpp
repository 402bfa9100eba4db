// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/mcap/mcap_reader.hpp"

#include <map>
#include <optional>

#include "fairway/io/mcap/mcap_format.hpp"

namespace fairway::io {

using mcap::ByteReader;
using mcap::Opcode;

namespace {

constexpr std::uint64_t kMaxChunk = 1ULL << 29U;  // before compression [bytes]

class Reader {
 public:
  Reader(std::string_view bytes,
         const std::string& name,
         const std::function<Expected<void>(const McapMessage&)>& on_message)
      : bytes_(bytes),
        name_(name),
        on_message_(on_message) {}

  Expected<void> read() {
    if (!bytes_.starts_with(mcap::kMagic)) return fail(name_ + ": expected an MCAP file");
    if (Expected<void> data = records(bytes_.substr(mcap::kMagic.size()), false); !data) {
      return data;
    }
    if (!ended_ || !bytes_.ends_with(mcap::kMagic)) {
      return fail(name_ + ": expected the end of an MCAP file, found a truncated file");
    }
    return {};
  }

 private:
  struct Channel {
    std::string topic;
    std::uint16_t schema = 0;
  };

  [[nodiscard]] tl::unexpected<Error> damaged(const char* what) const {
    return fail(name_ + ": expected a complete MCAP file, found a damaged " + what);
  }

  // Reads the records of the data section, or of a chunk.
  Expected<void> records(std::string_view bytes, bool in_chunk) {
    ByteReader in(bytes);
    while (!ended_ && !in.rest().empty()) {
      const std::string_view before = in.rest();
      const auto opcode = in.number<std::uint8_t>();
      const std::string_view content = in.bytes(in.number<std::uint64_t>());
      if (!in.ok()) return in_chunk ? Expected<void>(damaged("chunk")) : Expected<void>{};
      const Expected<void> done = record(static_cast<Opcode>(opcode), content, before, in_chunk);
      if (!done) return done;
    }
    return {};
  }

  // `from` is the start of the record, for the checksum of the data section.
  Expected<void> record(Opcode opcode,
                        std::string_view content,
                        std::string_view from,
                        bool in_chunk) {
    // Skips records that are not needed, and kinds that a later version may add.
    if (opcode == Opcode::Schema) return schema(content);
    if (opcode == Opcode::Channel) return channel(content);
    if (opcode == Opcode::Message) return message(content);
    if (opcode == Opcode::Chunk && !in_chunk) return chunk(content);
    if (opcode == Opcode::DataEnd && !in_chunk) return data_end(content, from);
    return {};
  }

  Expected<void> schema(std::string_view content) {
    ByteReader in(content);
    const auto id = in.number<std::uint16_t>();
    const std::string_view name = in.text();
    if (!in.ok()) return damaged("schema");
    schemas_[id] = name;
    return {};
  }

  Expected<void> channel(std::string_view content) {
    ByteReader in(content);
    const auto id = in.number<std::uint16_t>();
    const auto schema = in.number<std::uint16_t>();
    const std::string_view topic = in.text();
    if (!in.ok()) return damaged("channel");
    channels_[id] = {.topic = std::string(topic), .schema = schema};
    return {};
  }

  Expected<void> message(std::string_view content) {
    ByteReader in(content);
    const auto id = in.number<std::uint16_t>();
    const auto sequence = in.number<std::uint32_t>();
    const auto time = in.number<std::uint64_t>();
    static_cast<void>(in.number<std::uint64_t>());  // publish time
    const auto channel = channels_.find(id);
    if (!in.ok() || channel == channels_.end()) return damaged("message");
    return on_message_({.topic = channel->second.topic,
                        .schema_name = schemas_[channel->second.schema],
                        .sequence = sequence,
                        .time = time,
                        .content = in.rest()});
  }

  Expected<void> chunk(std::string_view content) {
    ByteReader in(content);
    static_cast<void>(in.bytes(16));  // first and last time
    const auto size = in.number<std::uint64_t>();
    const auto crc = in.number<std::uint32_t>();
    const std::string_view compression = in.text();
    const std::string_view stored = in.bytes(in.number<std::uint64_t>());
    if (!in.ok() || size > kMaxChunk) return damaged("chunk");
    std::optional<std::string> unpacked;
    if (compression == "zstd") {
      unpacked = mcap::decompress(stored, size);
    } else if (compression.empty()) {
      unpacked = std::string(stored);
    } else {
      return fail(name_ + ": expected chunks compressed by zstd or not at all, found " +
                  std::string(compression.substr(0, 20)));
    }
    if (!unpacked || (crc != 0 && mcap::crc32(*unpacked) != crc)) return damaged("chunk");
    return records(*unpacked, true);
  }

  Expected<void> data_end(std::string_view content, std::string_view from) {
    ByteReader in(content);
    const auto crc = in.number<std::uint32_t>();
    const std::string_view data = bytes_.substr(0, bytes_.size() - from.size());
    if (!in.ok() || (crc != 0 && mcap::crc32(data) != crc)) return damaged("data section");
    ended_ = true;
    return {};
  }

  std::string_view bytes_;
  const std::string& name_;
  const std::function<Expected<void>(const McapMessage&)>& on_message_;
  std::map<std::uint16_t, std::string> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  bool ended_ = false;
};

}  // namespace

Expected<void> read_mcap(std::string_view bytes,
                         const std::string& name,
                         const std::function<Expected<void>(const McapMessage&)>& on_message) {
  return Reader(bytes, name, on_message).read();
}

}  // namespace fairway::io
