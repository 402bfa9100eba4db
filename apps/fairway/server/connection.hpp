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

/// A WebSocket connection and the client at its other end. Used only in the network's thread.
class Connection {
 public:
  Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  virtual ~Connection() = default;

  /// Queues a message. A client that reads too slowly for too long is disconnected, but not within
  /// this call.
  virtual void send(std::shared_ptr<const std::string> message, bool binary) = 0;
};

/// Receives the events of a connection.
class Dialogue {
 public:
  Dialogue() = default;
  Dialogue(const Dialogue&) = delete;
  Dialogue& operator=(const Dialogue&) = delete;
  virtual ~Dialogue() = default;

  /// Called when the connection is open. It exists until `on_closed`; no message comes after that.
  virtual void on_open(Connection& connection) = 0;
  virtual void on_message(Connection& connection, std::string_view message, bool binary) = 0;
  virtual void on_closed(Connection& connection) = 0;
};

}  // namespace fairway::app
