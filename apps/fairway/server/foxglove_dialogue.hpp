// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "server/connection.hpp"
#include "server/live_messages.hpp"

namespace fairway::app {

/// Serves viewers by the protocol foxglove.websocket.v1: announces channels and sends subscribed
/// messages. A new subscriber receives the last message at once.
class FoxgloveDialogue final : public Dialogue {
 public:
  static constexpr const char* kProtocol = "foxglove.websocket.v1";

  void on_open(Connection& connection) override;
  void on_message(Connection& connection, std::string_view message, bool binary) override;
  void on_closed(Connection& connection) override;

  void publish(LiveMessages::Batch batch);

 private:
  struct Channel {
    io::McapChannel described;
    LiveMessages::Message last;  // empty content: none yet
  };
  using Subscriptions = std::map<std::uint32_t, std::uint32_t>;  // number, channel

  [[nodiscard]] static nlohmann::json advertisement(std::uint32_t id, const Channel& channel);
  void tell_all(const nlohmann::json& json);
  void replace_channels(LiveMessages::Batch& batch);
  void subscribe(Connection& connection, const nlohmann::json& list);
  void unsubscribe(Connection& connection, const nlohmann::json& list);

  std::map<std::uint32_t, Channel> channels_;
  std::map<Connection*, Subscriptions> viewers_;
};

}  // namespace fairway::app
