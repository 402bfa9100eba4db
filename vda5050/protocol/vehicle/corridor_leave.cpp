// SPDX-License-Identifier: Apache-2.0
#include "protocol/vehicle/corridor_leave.hpp"

#include <algorithm>

namespace fairway::vda5050 {

const CorridorLeave::Request* CorridorLeave::find(std::uint32_t sequence) const {
  const auto found = std::find_if(
      requests_.begin(), requests_.end(),
      [sequence](const Request& request) { return request.state.sequence == sequence; });
  return found != requests_.end() ? &*found : nullptr;
}

bool CorridorLeave::request(const std::string& order_id, const OrderEdge& edge) {
  if (find(edge.sequence) != nullptr) return false;
  requests_.push_back({.state = {.id = order_id + "/" + std::to_string(edge.sequence) + "/" +
                                       std::to_string(++count_),
                                 .edge_id = edge.id,
                                 .sequence = edge.sequence,
                                 .status = RequestStatus::Requested}});
  return true;
}

bool CorridorLeave::answer(const Response& response) {
  for (Request& request : requests_) {
    if (request.state.id != response.request_id) continue;
    const RequestStatus before = request.state.status;
    const std::optional<double> lease = request.lease_end;
    switch (response.grant) {
      case Grant::Granted:
        request.state.status = RequestStatus::Granted;
        request.lease_end = response.lease_end;
        break;
      case Grant::Queued:
        if (before == RequestStatus::Requested) request.state.status = RequestStatus::Queued;
        break;
      case Grant::Revoked:
      case Grant::Rejected:
        request.state.status = RequestStatus::Revoked;
        break;
    }
    return request.state.status != before || request.lease_end != lease;
  }
  return false;
}

bool CorridorLeave::expire(double now) {
  bool changed = false;
  for (Request& request : requests_) {
    if (request.state.status != RequestStatus::Granted) continue;
    if (!request.lease_end || now < *request.lease_end) continue;
    request.state.status = RequestStatus::Expired;
    changed = true;
  }
  return changed;
}

void CorridorLeave::finish(std::uint32_t sequence) {
  std::erase_if(requests_,
                [sequence](const Request& request) { return request.state.sequence == sequence; });
}

bool CorridorLeave::granted(std::uint32_t sequence) const {
  const Request* request = find(sequence);
  return request != nullptr && request->state.status == RequestStatus::Granted;
}

bool CorridorLeave::lost(std::uint32_t sequence) const {
  const Request* request = find(sequence);
  return request != nullptr && (request->state.status == RequestStatus::Revoked ||
                                request->state.status == RequestStatus::Expired);
}

std::vector<EdgeRequest> CorridorLeave::states() const {
  std::vector<EdgeRequest> states;
  for (const Request& request : requests_)
    states.push_back(request.state);
  return states;
}

}  // namespace fairway::vda5050
