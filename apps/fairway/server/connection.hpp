// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace fairway::app {

/// A message that several connections may send.
[[nodiscard]] inline std::shared_ptr<const std::string> shared(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

/// A WebSocket and the client at its other end. Used in the network's thread only.
class Connection {
 public:
  Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  virtual ~Connection() = default;

  /// Queues a message. One who reads too slowly for too long is disconnected, though not within
  /// this call.
  virtual void send(std::shared_ptr<const std::string> message, bool binary) = 0;
};

/// What talks through it.
class Dialogue {
 public:
  Dialogue() = default;
  Dialogue(const Dialogue&) = delete;
  Dialogue& operator=(const Dialogue&) = delete;
  virtual ~Dialogue() = default;

  /// The connection is open; it lives until `on_closed`, and no message comes after that.
  virtual void on_open(Connection& connection) = 0;
  virtual void on_message(Connection& connection, std::string_view message, bool binary) = 0;
  virtual void on_closed(Connection& connection) = 0;
};

}  // namespace fairway::app
