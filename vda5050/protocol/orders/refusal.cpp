// SPDX-License-Identifier: Apache-2.0
#include "protocol/orders/refusal.hpp"

#include <utility>

namespace fairway::vda5050 {

namespace {

struct Names {
  const char* second;
  const char* third;
};

constexpr Names names_of(Fault fault) noexcept {
  switch (fault) {
    case Fault::Validation:
      return {"validationError", "VALIDATION_FAILURE"};
    case Fault::UnsupportedField:
      return {"orderError", "UNSUPPORTED_PARAMETER"};
    case Fault::UnknownAction:
      return {"orderError", "INVALID_ORDER_ACTION"};
    case Fault::TooLarge:
      return {"orderError", "INSUFFICIENT_MEMORY"};
    case Fault::NotAvailable:
      return {"orderError", "MOBILE_ROBOT_NOT_AVAILABLE"};
    case Fault::OtherOrderActive:
      return {"orderError", "OTHER_ORDER_ACTIVE"};
    case Fault::UnknownMap:
      return {"orderError", "UNKNOWN_MAP_ID"};
    case Fault::StartNode:
      return {"orderError", "START_NODE_OUT_OF_RANGE"};
    case Fault::NoRoute:
      return {"orderError", "NO_ROUTE_TO_TARGET"};
    case Fault::OutdatedUpdate:
      return {"orderUpdateError", "OUTDATED_ORDER_UPDATE"};
    case Fault::UpdateAfterCancel:
      return {"orderUpdateError", "ORDER_UPDATE_FOLLOWING_CANCEL"};
    case Fault::SameUpdate:
      return {"orderUpdateError", "SAME_ORDER_UPDATE_ID"};
    case Fault::Stitching:
      return {"orderUpdateError", "VALIDATION_FAILURE"};
    case Fault::NothingToCancel:
      return {"noOrderToCancel", "NO_ORDER_TO_CANCEL"};
    case Fault::InvalidAction:
      return {"instantActionError", "INVALID_INSTANT_ACTION"};
    case Fault::OutsideCorridor:
      return {"outsideOfCorridor", "OUTSIDE_OF_CORRIDOR"};
    case Fault::NotLocalized:
      return {"localizationError", "LOCALIZATION_ERROR"};
    case Fault::NodeUnreachable:
      return {"nodeUnreachable", "NODE_UNREACHABLE"};
    case Fault::CorridorClosed:
      return {"corridorClosed", "CORRIDOR_CLOSED"};
    case Fault::BlockedZone:
      return {"blockedZoneViolation", "BLOCKED_ZONE_VIOLATION"};
    case Fault::DuplicateZoneSet:
      return {"duplicateZoneSet", "DUPLICATE_ZONE_SET"};
    case Fault::ReleaseLost:
    case Fault::ZoneLeaveLost:
      return {"releaseLost", "RELEASE_LOST"};
  }
  return {"validationError", "VALIDATION_FAILURE"};
}

}  // namespace

const char* type_of(Fault fault, ProtocolVersion version) noexcept {
  return is_v3(version) ? names_of(fault).third : names_of(fault).second;
}

ErrorLevel level_of(Fault fault) noexcept {
  switch (fault) {
    case Fault::TooLarge:
      return ErrorLevel::Urgent;
    case Fault::UnsupportedField:
    case Fault::OutsideCorridor:
    case Fault::NodeUnreachable:
    case Fault::BlockedZone:
    case Fault::ReleaseLost:
    case Fault::ZoneLeaveLost:
      return ErrorLevel::Critical;
    case Fault::NotLocalized:
      return ErrorLevel::Fatal;
    case Fault::Validation:
    case Fault::UnknownAction:
    case Fault::NotAvailable:
    case Fault::OtherOrderActive:
    case Fault::UnknownMap:
    case Fault::StartNode:
    case Fault::NoRoute:
    case Fault::OutdatedUpdate:
    case Fault::UpdateAfterCancel:
    case Fault::SameUpdate:
    case Fault::Stitching:
    case Fault::NothingToCancel:
    case Fault::InvalidAction:
    case Fault::CorridorClosed:
    case Fault::DuplicateZoneSet:
      return ErrorLevel::Warning;
  }
  return ErrorLevel::Warning;
}

VehicleError make_error(Fault fault,
                        ProtocolVersion version,
                        std::string description,
                        std::vector<Reference> references) {
  return {.type = type_of(fault, version),
          .level = level_of(fault),
          .description = std::move(description),
          .references = std::move(references)};
}

}  // namespace fairway::vda5050
