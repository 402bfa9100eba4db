// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fairway/io/recording/recording.hpp"

namespace fairway::app {

/// The messages of a live run. They are kept as a recording, and passed in batches to the listener.
class LiveMessages final : public io::MessageSink {
 public:
  struct Message {
    std::uint32_t channel = 0;
    std::uint64_t time = 0;  ///< [ns]
    std::string content;
  };
  /// New messages. Channels are numbered from `first_channel` on through all runs.
  struct Batch {
    bool begins_run = false;
    std::uint32_t first_channel = 0;  ///< number of the first of the new channels
    std::vector<io::McapChannel> channels;
    std::vector<Message> messages;
  };

  /// @param first_channel  Number of this run's first channel for the listener.
  explicit LiveMessages(std::uint32_t first_channel)
      : first_channel_(first_channel),
        batch_{.begins_run = true, .first_channel = first_channel, .channels = {}, .messages = {}} {
  }

  std::uint16_t add_channel(const io::McapChannel& channel) override;
  [[nodiscard]] bool wants(std::uint16_t channel) const override;
  void write(std::uint16_t channel, std::uint64_t time, std::string_view message) override;

  [[nodiscard]] Batch take();
  [[nodiscard]] std::uint32_t next_channel() const noexcept { return next_channel_; }

  /// The whole recording as it is now.
  [[nodiscard]] std::string recording() const;

  /// Returns whether the recording has reached its greatest size and has ended.
  [[nodiscard]] bool full() const noexcept;

 private:
  std::uint32_t first_channel_;
  std::uint32_t next_channel_ = first_channel_;
  Batch batch_;
  io::McapWriter writer_;
};

}  // namespace fairway::app
