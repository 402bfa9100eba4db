// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "fairway/base/error.hpp"
#include "protocol/messages/protocol_version.hpp"

namespace fairway::vda5050 {

/// A message that a client sends in place of a fleet control, for trying things out.
struct ClientRequest {
  std::string host = "localhost";
  int port = 1883;
  VehicleIdentity vehicle;
  nlohmann::json message;   ///< order, instant actions or zone set; the header is replaced
  double patience = 600.0;  ///< until the result must be there [s]
};

/// How a message ended.
struct ClientResult {
  bool done = false;          ///< the order was driven, or the actions are FINISHED
  std::string text;           ///< why not, or what was done
  nlohmann::json last_state;  ///< of the vehicle
};

/// The topic that a message belongs to by its fields; none if it is no message for a vehicle.
[[nodiscard]] std::optional<Topic> topic_of(const nlohmann::json& message);

/// What a state says about a message that was sent: the result, or none while it goes on.
[[nodiscard]] std::optional<ClientResult> result_of(const nlohmann::json& sent,
                                                    const nlohmann::json& state);

/// Sends a message and follows the vehicle's states until it is done.
/// @param progress  Called with a line of text whenever the vehicle passes a node.
/// @return an error if the broker or the vehicle is not reachable.
[[nodiscard]] Expected<ClientResult> send_message(
    const ClientRequest& request, const std::function<void(const std::string&)>& progress);

}  // namespace fairway::vda5050
