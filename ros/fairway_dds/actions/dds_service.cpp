// SPDX-License-Identifier: Apache-2.0
#include "fairway_dds/actions/dds_service.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <vector>

namespace fairway::dds {

namespace {

struct EndpointDeleter {
  void operator()(dds_builtintopic_endpoint_t* endpoint) const noexcept {
    dds_builtintopic_free_endpoint(endpoint);
  }
};
using Endpoint = std::unique_ptr<dds_builtintopic_endpoint_t, EndpointDeleter>;

using Handles = std::vector<dds_instance_handle_t>;

template <typename Get>
Handles matched(dds_entity_t entity, Get&& get) {
  constexpr std::size_t kMost = 256;
  Handles handles(kMost);
  const dds_return_t count = get(entity, handles.data(), kMost);
  handles.resize(std::min(kMost, static_cast<std::size_t>(std::max(0, count))));
  return handles;
}

// Returns the value of a key in the user data "key=value;key=value;", empty if there is none.
std::string value_of(const dds_builtintopic_endpoint_t* endpoint, const std::string& key) {
  void* data = nullptr;
  std::size_t size = 0;
  if (endpoint == nullptr || !dds_qget_userdata(endpoint->qos, &data, &size)) return {};
  std::string text(1, ';');
  if (data != nullptr) text.append(static_cast<const char*>(data), size);
  dds_free(data);
  const std::size_t begin = text.find(";" + key + "=");
  if (begin == std::string::npos) return {};
  const std::size_t value = begin + key.size() + 2;
  return text.substr(value, text.find(';', value) - value);
}

}  // namespace

ClientState state_of_client(dds_entity_t requests,
                            dds_instance_handle_t writer,
                            dds_entity_t replies) {
  const Endpoint origin(dds_get_matched_publication_data(requests, writer));
  if (!origin) return ClientState::Gone;
  const std::string client = value_of(origin.get(), "clientid");
  if (client.empty()) return ClientState::Foreign;
  for (const dds_instance_handle_t reader : matched(replies, dds_get_matched_subscriptions)) {
    const Endpoint endpoint(dds_get_matched_subscription_data(replies, reader));
    if (value_of(endpoint.get(), "clientid") == client) return ClientState::Ready;
  }
  return ClientState::Pending;
}

bool has_server(dds_entity_t requests, dds_entity_t replies) {
  std::vector<std::string> servers;
  for (const dds_instance_handle_t reader : matched(requests, dds_get_matched_subscriptions)) {
    const Endpoint endpoint(dds_get_matched_subscription_data(requests, reader));
    servers.push_back(value_of(endpoint.get(), "serviceid"));
  }
  for (const dds_instance_handle_t writer : matched(replies, dds_get_matched_publications)) {
    const Endpoint endpoint(dds_get_matched_publication_data(replies, writer));
    const std::string server = value_of(endpoint.get(), "serviceid");
    if (!server.empty() && std::count(servers.begin(), servers.end(), server) > 0) return true;
  }
  return false;
}

Quality service_quality(const Participant& participant, const std::string& key) {
  static std::atomic<std::uint32_t> number{0};
  dds_guid_t guid{};
  dds_get_guid(participant.get(), &guid);
  std::string id;
  const auto add = [&id](unsigned value) {
    char text[16];
    std::snprintf(static_cast<char*>(text), sizeof(text), "%x.", value);
    id += static_cast<const char*>(text);
  };
  for (const std::uint8_t byte : guid.v)
    add(byte);
  add(++number);
  return {.user_data = key + "=" + id + ";"};
}

}  // namespace fairway::dds
