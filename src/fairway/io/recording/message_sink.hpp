// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "fairway/io/mcap/mcap_writer.hpp"

namespace fairway::io {

/// Where messages go: a recording, or viewers that listen.
class MessageSink {
 public:
  MessageSink() = default;
  MessageSink(const MessageSink&) = delete;
  MessageSink& operator=(const MessageSink&) = delete;
  virtual ~MessageSink() = default;

  /// Announces a channel; the numbers count up from 0.
  virtual std::uint16_t add_channel(const McapChannel& channel) = 0;

  /// Whether anybody wants the channel's messages now: those that nobody wants need not be made.
  [[nodiscard]] virtual bool wants(std::uint16_t channel) const = 0;

  /// @param time  When it was true [ns].
  virtual void write(std::uint16_t channel, std::uint64_t time, std::string_view message) = 0;
};

}  // namespace fairway::io
