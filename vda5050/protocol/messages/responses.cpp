// SPDX-License-Identifier: Apache-2.0
#include "protocol/messages/responses.hpp"

#include <array>

#include "protocol/messages/timestamp.hpp"

namespace fairway::vda5050 {

std::vector<Response> read_responses(FieldReader& reader) {
  static constexpr std::array<const char*, 4> kGrants{"GRANTED", "QUEUED", "REVOKED", "REJECTED"};
  std::vector<Response> responses;
  for (FieldReader& item : reader.objects("responses")) {
    Response response{.request_id = item.text("requestId"),
                      .grant = static_cast<Grant>(item.word("grantType", kGrants))};
    if (item.has("leaseExpiry")) {
      const std::string text = item.text("leaseExpiry");
      response.lease_end = from_timestamp(text);
      if (!response.lease_end)
        item.complain("leaseExpiry", "expected a time of ISO 8601, found \"" + text + "\"");
    }
    responses.push_back(std::move(response));
  }
  return responses;
}

}  // namespace fairway::vda5050
