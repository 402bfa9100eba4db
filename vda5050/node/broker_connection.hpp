// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "protocol/vehicle/vehicle.hpp"

namespace fairway::vda5050 {

/// Where the broker is and how to log in. Passwords come from a file, never from the command line.
struct BrokerAddress {
  std::string host = "localhost";
  int port = 1883;
  std::string user;
  std::string password;
  std::string ca_file;    ///< turns TLS on
  std::string cert_file;  ///< client certificate
  std::string key_file;
};

/// Wakes the main loop when a connection has news.
class Wakeup {
 public:
  Wakeup();
  ~Wakeup();
  Wakeup(const Wakeup&) = delete;
  Wakeup& operator=(const Wakeup&) = delete;

  void notify() noexcept;
  /// Waits for news, at most `seconds`.
  void wait(double seconds);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One thing that happened on a connection.
struct BrokerEvent {
  enum class Kind : std::uint8_t {
    Ready,    ///< connected, and the topics are subscribed
    Lost,     ///< the broker is not reachable any more
    Refused,  ///< the broker refused the connection; `payload` says why
    Message,
  };
  Kind kind = Kind::Message;
  Topic topic = Topic::Order;
  std::string payload;
};

/// The connection of one vehicle to the broker: its own client with its own last will. It connects
/// again by itself.
class BrokerConnection {
 public:
  /// @param will  Published by the broker when the connection breaks.
  /// @throws std::runtime_error if the client cannot be made or TLS files are missing.
  BrokerConnection(const BrokerAddress& address,
                   const VehicleIdentity& identity,
                   const OutgoingMessage& will,
                   Wakeup& wakeup);
  ~BrokerConnection();
  BrokerConnection(const BrokerConnection&) = delete;
  BrokerConnection& operator=(const BrokerConnection&) = delete;

  void start();

  /// Sends a message; without a connection it is dropped.
  void publish(const OutgoingMessage& message);

  /// Sends a last message, waits at most `seconds` until the broker has it, and disconnects.
  void finish(const OutgoingMessage& last, double seconds);

  /// Returns what happened since the last call.
  [[nodiscard]] std::vector<BrokerEvent> take_events();

  [[nodiscard]] bool connected() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Initialises the MQTT library for the time of its life.
class MqttLibrary {
 public:
  MqttLibrary();
  ~MqttLibrary();
  MqttLibrary(const MqttLibrary&) = delete;
  MqttLibrary& operator=(const MqttLibrary&) = delete;
};

}  // namespace fairway::vda5050
