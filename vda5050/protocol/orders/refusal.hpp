// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "protocol/messages/protocol_version.hpp"
#include "protocol/messages/vehicle_state.hpp"

namespace fairway::vda5050 {

/// Why a message is refused, or what is wrong with the vehicle; each has a type in every version.
enum class Fault : std::uint8_t {
  Validation,         ///< not JSON, not the schema, no valid graph
  UnsupportedField,   ///< a field of the standard that the vehicle cannot honour
  UnknownAction,      ///< an action that the vehicle cannot do
  TooLarge,           ///< more than the factsheet allows
  NotAvailable,       ///< the operating mode takes no orders
  OtherOrderActive,   ///< another order is not finished
  UnknownMap,         ///< a node on another map
  StartNode,          ///< the vehicle is not at the first node
  NoRoute,            ///< a node cannot be reached
  OutdatedUpdate,     ///< an orderUpdateId below the present one
  UpdateAfterCancel,  ///< an update of an order that was cancelled
  SameUpdate,         ///< the present orderUpdateId with other content
  Stitching,          ///< an update that does not begin at the end of the base
  NothingToCancel,    ///< cancelOrder without an order
  InvalidAction,      ///< an instant action that cannot be done
  OutsideCorridor,    ///< the vehicle is outside the strip of its edge
  NotLocalized,       ///< no valid position
  NodeUnreachable,    ///< a node cannot be reached, found on the way
  CorridorClosed,     ///< an obstacle closes the strip; the vehicle waits
  BlockedZone,        ///< the vehicle is in a blocked zone
  DuplicateZoneSet,   ///< a zone set with a known id
  ReleaseLost,
  ZoneLeaveLost,  ///< the leave for a corridor ended while it was used
};

/// Type of a fault in messages of a version.
[[nodiscard]] const char* type_of(Fault fault, ProtocolVersion version) noexcept;

/// Level of a fault; version 2 has fewer levels, and the writer maps them.
[[nodiscard]] ErrorLevel level_of(Fault fault) noexcept;

[[nodiscard]] VehicleError make_error(Fault fault,
                                      ProtocolVersion version,
                                      std::string description,
                                      std::vector<Reference> references = {});

}  // namespace fairway::vda5050
