// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "protocol/messages/responses.hpp"
#include "protocol/messages/vehicle_state.hpp"

namespace fairway::vda5050 {

/// Requests for leave to use a corridor or to enter a zone, one for each.
/// @tparam Key  What a request is about: the sequence number of an edge, or the id of a zone.
template <typename Key>
class LeaveRequests {
 public:
  struct Request {
    std::string id;    ///< unique over all requests of the vehicle
    std::string name;  ///< of the edge, or of the zone's set
    Key key{};
    RequestStatus status = RequestStatus::Requested;
    std::optional<double> lease_end{};  ///< [s since 1970]
  };

  /// Requests leave, once. @param prefix  Of the request's id. @return whether one was added.
  bool request(const std::string& prefix, const Key& key, const std::string& name) {
    if (find(key) != nullptr) return false;
    requests_.push_back({.id = prefix + "/" + std::to_string(++count_), .name = name, .key = key});
    return true;
  }

  /// Applies the fleet control's answer to one request. @return whether anything changed.
  bool answer(const Response& response) {
    for (Request& request : requests_) {
      if (request.id != response.request_id) continue;
      const RequestStatus before = request.status;
      const std::optional<double> lease = request.lease_end;
      switch (response.grant) {
        case Grant::Granted:
          request.status = RequestStatus::Granted;
          request.lease_end = response.lease_end;
          break;
        case Grant::Queued:
          if (before == RequestStatus::Requested) request.status = RequestStatus::Queued;
          break;
        case Grant::Revoked:
        case Grant::Rejected:
          request.status = RequestStatus::Revoked;
          break;
      }
      return request.status != before || request.lease_end != lease;
    }
    return false;
  }

  /// Ends leases that are over. @return whether anything changed.
  bool expire(double now) {
    bool changed = false;
    for (Request& request : requests_) {
      if (request.status != RequestStatus::Granted) continue;
      if (!request.lease_end || now < *request.lease_end) continue;
      request.status = RequestStatus::Expired;
      changed = true;
    }
    return changed;
  }

  /// Removes the request about something that the vehicle has left. @return whether there was one.
  bool finish(const Key& key) {
    return std::erase_if(requests_, [&](const Request& request) { return request.key == key; }) > 0;
  }

  void clear() { requests_.clear(); }

  [[nodiscard]] bool granted(const Key& key) const {
    const Request* request = find(key);
    return request != nullptr && request->status == RequestStatus::Granted;
  }

  /// Returns whether leave was given or asked for and has ended.
  [[nodiscard]] bool lost(const Key& key) const {
    const Request* request = find(key);
    return request != nullptr &&
           (request->status == RequestStatus::Revoked || request->status == RequestStatus::Expired);
  }

  [[nodiscard]] const std::vector<Request>& all() const noexcept { return requests_; }

 private:
  [[nodiscard]] const Request* find(const Key& key) const {
    const auto found = std::find_if(requests_.begin(), requests_.end(),
                                    [&](const Request& request) { return request.key == key; });
    return found != requests_.end() ? &*found : nullptr;
  }

  std::vector<Request> requests_;
  std::uint64_t count_ = 0;  // of all requests ever made
};

}  // namespace fairway::vda5050
