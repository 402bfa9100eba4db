// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "protocol/messages/protocol_version.hpp"
#include "protocol/messages/vehicle_state.hpp"

namespace fairway::vda5050 {

/// Writes the body of a state message: all fields but the header.
[[nodiscard]] nlohmann::json state_json(const VehicleState& state, ProtocolVersion version);

/// Writes the body of a visualization message.
/// @param state_header  headerId of the state that it belongs to, for version 3.
[[nodiscard]] nlohmann::json visualization_json(const VehicleState& state,
                                                ProtocolVersion version,
                                                std::uint32_t state_header);

}  // namespace fairway::vda5050
