// SPDX-License-Identifier: Apache-2.0
#include "server/live_messages.hpp"

#include <utility>

namespace fairway::app {

namespace {

constexpr std::uint64_t kMostBytes = 256U << 20U;  // of a recording in memory

}  // namespace

std::uint16_t LiveMessages::add_channel(const io::McapChannel& channel) {
  batch_.channels.push_back(channel);
  ++next_channel_;
  return writer_.add_channel(channel);
}

bool LiveMessages::wants(std::uint16_t /*channel*/) const { return true; }

void LiveMessages::write(std::uint16_t channel, std::uint64_t time, std::string_view message) {
  if (!full()) writer_.write(channel, time, message);
  batch_.messages.push_back(
      {.channel = first_channel_ + channel, .time = time, .content = std::string(message)});
}

LiveMessages::Batch LiveMessages::take() {
  return std::exchange(
      batch_,
      {.begins_run = false, .first_channel = next_channel_, .channels = {}, .messages = {}});
}

std::string LiveMessages::recording() const {
  io::McapWriter copy = writer_;
  copy.finish();
  return copy.take();
}

bool LiveMessages::full() const noexcept { return writer_.size() > kMostBytes; }

}  // namespace fairway::app
