// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>

#include "server/connection.hpp"
#include "server/live_world.hpp"

namespace fairway::app {

/// Serves the pages that show a live world. Records are sent as binary messages, state and notices
/// as JSON; commands are received as JSON. A viewer that joins late first receives the last
/// minutes.
class PageDialogue final : public Dialogue {
 public:
  explicit PageDialogue(LiveWorld& world) : world_(world) {}

  void on_open(Connection& connection) override;
  void on_message(Connection& connection, std::string_view message, bool binary) override;
  void on_closed(Connection& connection) override;

  void run(std::string records);
  void records(std::string records);
  void beginning(std::string records);
  void state(const LiveState& state);
  void notice(const std::string& text);
  void refusal(const Refusal& refusal);

 private:
  using Bytes = std::shared_ptr<const std::string>;

  void send_all(const Bytes& message, bool binary);

  // A part of the past: records that begin it, and all records until the next part.
  struct Stretch {
    Bytes beginning;
    std::string records;
  };

  LiveWorld& world_;
  std::map<Connection*, std::uint64_t> connections_;  // their numbers
  std::uint64_t next_client_ = 1;
  std::deque<Stretch> past_;
  Bytes state_;
};

}  // namespace fairway::app
