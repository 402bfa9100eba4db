// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/mcap/mcap_writer.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "fairway/io/mcap/mcap_format.hpp"

namespace fairway::io {

using mcap::append_record;
using mcap::ByteWriter;
using mcap::Opcode;

namespace {

constexpr std::size_t kChunkSize = 1U << 20U;  // before compression [bytes]
constexpr std::string_view kCompression = "zstd";

}  // namespace

McapWriter::McapWriter() {
  append(mcap::kMagic);
  std::string header;
  ByteWriter out(header);
  out.text("");  // no profile
  out.text("fairway");
  std::string record;
  append_record(record, Opcode::Header, header);
  append(record);
}

std::uint16_t McapWriter::add_channel(const McapChannel& channel) {
  if (channels_.size() >= 0xFFFF) throw std::length_error("too many channels");
  auto [schema, is_new] = schema_ids_.try_emplace(
      channel.schema_name, static_cast<std::uint16_t>(schemas_.size() + 1));  // 0 means none
  if (is_new) {
    ByteWriter out(schemas_.emplace_back());
    out.number(schema->second);
    out.text(channel.schema_name);
    out.text("jsonschema");
    out.text(channel.schema);
  }
  const auto id = static_cast<std::uint16_t>(channels_.size());
  Channel& added = channels_.emplace_back();
  added.schema = schema->second;
  ByteWriter out(added.record);
  out.number(id);
  out.number(schema->second);
  out.text(channel.topic);
  out.text("json");
  out.text("");  // no metadata
  return id;
}

void McapWriter::write(std::uint16_t channel, std::uint64_t time, std::string_view message) {
  Channel& to = channels_.at(channel);
  if (!to.declared) {
    append_record(chunk_, Opcode::Schema, schemas_[to.schema - 1U]);
    append_record(chunk_, Opcode::Channel, to.record);
    to.declared = true;
  }
  const bool first = std::all_of(channels_.begin(), channels_.end(),
                                 [](const Channel& c) { return c.index.empty(); });
  chunk_start_time_ = first ? time : std::min(chunk_start_time_, time);
  chunk_end_time_ = first ? time : std::max(chunk_end_time_, time);
  to.index.emplace_back(time, chunk_.size());
  std::string content;
  ByteWriter out(content);
  out.number(channel);
  out.number(to.messages++);
  out.number(time);
  out.number(time);
  content.append(message);
  append_record(chunk_, Opcode::Message, content);
  if (chunk_.size() >= kChunkSize) close_chunk();
}

void McapWriter::finish() {
  close_chunk();
  std::string data_end;
  ByteWriter(data_end).number(crc_);
  std::string record;
  append_record(record, Opcode::DataEnd, data_end);
  append(record);
  append(summary());
  append(mcap::kMagic);
}

std::string McapWriter::take() { return std::exchange(ready_, {}); }

void McapWriter::append(std::string_view bytes) {
  ready_.append(bytes);
  written_ += bytes.size();
  crc_ = mcap::crc32(bytes, crc_);
}

void McapWriter::close_chunk() {
  if (chunk_.empty()) return;
  const std::string compressed = mcap::compress(chunk_);
  ChunkIndex& index = chunks_.emplace_back();
  index.start_time = chunk_start_time_;
  index.end_time = chunk_end_time_;
  index.start = written_;
  index.compressed = compressed.size();
  index.uncompressed = chunk_.size();

  std::string content;
  ByteWriter out(content);
  out.number(chunk_start_time_);
  out.number(chunk_end_time_);
  out.number<std::uint64_t>(chunk_.size());
  out.number(mcap::crc32(chunk_));
  out.text(kCompression);
  out.number<std::uint64_t>(compressed.size());
  content.append(compressed);
  std::string record;
  append_record(record, Opcode::Chunk, content);
  append(record);
  index.length = record.size();

  const std::uint64_t indexes_start = written_;
  for (std::size_t id = 0; id < channels_.size(); ++id) {
    auto& entries = channels_[id].index;
    if (entries.empty()) continue;
    index.message_indexes[static_cast<std::uint16_t>(id)] = written_;
    content.clear();
    out.number(static_cast<std::uint16_t>(id));
    out.number(static_cast<std::uint32_t>(entries.size() * 16));
    for (const auto& [time, offset] : entries) {
      out.number(time);
      out.number(offset);
    }
    record.clear();
    append_record(record, Opcode::MessageIndex, content);
    append(record);
    entries.clear();
  }
  index.message_indexes_length = written_ - indexes_start;
  chunk_.clear();
}

std::string McapWriter::statistics() const {
  std::uint64_t messages = 0;
  std::uint64_t start = chunks_.empty() ? 0 : chunks_.front().start_time;
  std::uint64_t end = 0;
  for (const Channel& channel : channels_)
    messages += channel.messages;
  for (const ChunkIndex& chunk : chunks_) {
    start = std::min(start, chunk.start_time);
    end = std::max(end, chunk.end_time);
  }
  std::string content;
  ByteWriter out(content);
  out.number(messages);
  out.number(static_cast<std::uint16_t>(schemas_.size()));
  out.number(static_cast<std::uint32_t>(channels_.size()));
  out.number<std::uint32_t>(0);  // attachments
  out.number<std::uint32_t>(0);  // metadata
  out.number(static_cast<std::uint32_t>(chunks_.size()));
  out.number(start);
  out.number(end);
  out.number(static_cast<std::uint32_t>(channels_.size() * 10));
  for (std::size_t id = 0; id < channels_.size(); ++id) {
    out.number(static_cast<std::uint16_t>(id));
    out.number<std::uint64_t>(channels_[id].messages);
  }
  return content;
}

// Writes everything between the data's end and the closing magic: summary, summary offsets, footer.
std::string McapWriter::summary() const {
  std::string bytes;
  std::string offsets;
  const auto group = [&](Opcode opcode, const auto& append_all) {
    const std::uint64_t start = written_ + bytes.size();
    append_all();
    const std::uint64_t length = written_ + bytes.size() - start;
    if (length == 0) return;
    std::string content;
    ByteWriter out(content);
    out.number(static_cast<std::uint8_t>(opcode));
    out.number(start);
    out.number(length);
    append_record(offsets, Opcode::SummaryOffset, content);
  };
  group(Opcode::Schema, [&] {
    for (const std::string& schema : schemas_)
      append_record(bytes, Opcode::Schema, schema);
  });
  group(Opcode::Channel, [&] {
    for (const Channel& channel : channels_)
      append_record(bytes, Opcode::Channel, channel.record);
  });
  group(Opcode::Statistics, [&] { append_record(bytes, Opcode::Statistics, statistics()); });
  group(Opcode::ChunkIndex, [&] {
    for (const ChunkIndex& chunk : chunks_) {
      std::string content;
      ByteWriter out(content);
      out.number(chunk.start_time);
      out.number(chunk.end_time);
      out.number(chunk.start);
      out.number(chunk.length);
      out.number(static_cast<std::uint32_t>(chunk.message_indexes.size() * 10));
      for (const auto& [channel, offset] : chunk.message_indexes) {
        out.number(channel);
        out.number(offset);
      }
      out.number(chunk.message_indexes_length);
      out.text(kCompression);
      out.number(chunk.compressed);
      out.number(chunk.uncompressed);
      append_record(bytes, Opcode::ChunkIndex, content);
    }
  });
  const std::uint64_t offsets_start = written_ + bytes.size();
  bytes.append(offsets);
  // The summary's CRC covers the footer up to the CRC field.
  ByteWriter out(bytes);
  out.number(static_cast<std::uint8_t>(Opcode::Footer));
  out.number<std::uint64_t>(20);
  out.number(written_);
  out.number(offsets_start);
  out.number(mcap::crc32(bytes));
  return bytes;
}

}  // namespace fairway::io
