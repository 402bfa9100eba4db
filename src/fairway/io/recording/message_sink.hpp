// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "fairway/io/mcap/mcap_writer.hpp"

namespace fairway::io {

/// The destination of messages: a recording, or connected viewers.
class MessageSink {
 public:
  MessageSink() = default;
  MessageSink(const MessageSink&) = delete;
  MessageSink& operator=(const MessageSink&) = delete;
  virtual ~MessageSink() = default;

  /// Announces a channel; the numbers count up from 0.
  virtual std::uint16_t add_channel(const McapChannel& channel) = 0;

  /// Whether any receiver wants the channel's messages now; otherwise they need not be made.
  [[nodiscard]] virtual bool wants(std::uint16_t channel) const = 0;

  /// @param time  The time to which the message refers [ns].
  virtual void write(std::uint16_t channel, std::uint64_t time, std::string_view message) = 0;
};

}  // namespace fairway::io
