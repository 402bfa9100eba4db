// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocol/messages/order.hpp"
#include "protocol/messages/responses.hpp"
#include "protocol/messages/vehicle_state.hpp"

namespace fairway::vda5050 {

/// Requests for leave to use corridors that need it. A vehicle without leave stays on its line.
class CorridorLeave {
 public:
  /// Requests leave for an edge, once.
  /// @return whether a request was added.
  bool request(const std::string& order_id, const OrderEdge& edge);

  /// Applies the fleet control's answer to one request.
  /// @return whether anything changed.
  bool answer(const Response& response);

  /// Ends leases that are over. @return whether anything changed.
  bool expire(double now);

  /// Removes the request of an edge that the vehicle has left.
  void finish(std::uint32_t sequence);

  void clear() { requests_.clear(); }

  [[nodiscard]] bool granted(std::uint32_t sequence) const;
  /// Returns whether leave was given and has ended.
  [[nodiscard]] bool lost(std::uint32_t sequence) const;
  [[nodiscard]] std::vector<EdgeRequest> states() const;

 private:
  struct Request {
    EdgeRequest state;
    std::optional<double> lease_end{};  // [s since 1970]
  };

  [[nodiscard]] const Request* find(std::uint32_t sequence) const;

  std::vector<Request> requests_;
  std::uint64_t count_ = 0;  // of all requests ever made
};

}  // namespace fairway::vda5050
