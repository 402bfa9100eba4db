// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/messages/field_reader.hpp"

namespace fairway::vda5050 {

/// The fleet control's answer to a request.
enum class Grant : std::uint8_t { Granted, Queued, Revoked, Rejected };

struct Response {
  std::string request_id;
  Grant grant = Grant::Queued;
  std::optional<double> lease_end{};  ///< [s since 1970]
};

/// Reads a message of the topic `responses`.
[[nodiscard]] std::vector<Response> read_responses(FieldReader& reader);

}  // namespace fairway::vda5050
