// SPDX-License-Identifier: Apache-2.0
#include "node/order_client.hpp"

#include <mosquitto.h>

#include <chrono>
#include <memory>
#include <utility>

#include "protocol/messages/timestamp.hpp"

namespace fairway::vda5050 {

using nlohmann::json;

namespace {

double client_clock() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

struct Client {
  const ClientRequest& request;
  const std::function<void(const std::string&)>& progress;
  json message;
  std::string state_topic;
  bool subscribed = false;
  bool connected = false;
  std::string refusal;
  bool seen = false;  // a state of the vehicle
  bool sent = false;
  std::string last_node;
  std::optional<ClientResult> result{};

  void take(const std::string& topic, const std::string& payload) {
    if (topic != state_topic) return;
    const json state = json::parse(payload, nullptr, false);
    if (!state.is_object()) return;
    seen = true;
    // A retained or earlier state says nothing about a message that is not sent yet.
    if (!sent || result) return;
    const std::string node = state.value("lastNodeId", "");
    if (node != last_node && !node.empty()) {
      progress("node \"" + node + "\" passed");
      last_node = node;
    }
    result = result_of(message, state);
  }
};

struct Mosquitto {
  Mosquitto() { mosquitto_lib_init(); }
  ~Mosquitto() {
    if (client != nullptr) mosquitto_destroy(client);
    mosquitto_lib_cleanup();
  }
  Mosquitto(const Mosquitto&) = delete;
  Mosquitto& operator=(const Mosquitto&) = delete;
  mosquitto* client = nullptr;
};

void set_callbacks(mosquitto* client) {
  mosquitto_connect_callback_set(client, [](mosquitto* own, void* self, int code) {
    auto& state = *static_cast<Client*>(self);
    state.connected = code == 0;
    if (code != 0) state.refusal = mosquitto_connack_string(code);
    if (code == 0) mosquitto_subscribe(own, nullptr, state.state_topic.c_str(), 0);
  });
  mosquitto_subscribe_callback_set(client, [](mosquitto*, void* self, int, int, const int*) {
    static_cast<Client*>(self)->subscribed = true;
  });
  mosquitto_message_callback_set(
      client, [](mosquitto*, void* self, const mosquitto_message* received) {
        const auto length = static_cast<std::size_t>(received->payloadlen);
        static_cast<Client*>(self)->take(
            received->topic, std::string(static_cast<const char*>(received->payload), length));
      });
}

json with_header(json message, const VehicleIdentity& vehicle) {
  message["headerId"] = 0;
  message["timestamp"] = to_timestamp(client_clock());
  message["version"] = to_text(vehicle.version);
  message["manufacturer"] = vehicle.manufacturer;
  message["serialNumber"] = vehicle.serial;
  return message;
}

}  // namespace

Expected<ClientResult> send_message(const ClientRequest& request,
                                    const std::function<void(const std::string&)>& progress) {
  const std::optional<Topic> topic = topic_of(request.message);
  if (!topic) return fail("expected an order, instant actions, a zone set or responses");
  Client state{.request = request,
               .progress = progress,
               .message = with_header(request.message, request.vehicle),
               .state_topic = topic_path(request.vehicle, Topic::State)};
  Mosquitto library;
  library.client = mosquitto_new(nullptr, true, &state);
  if (library.client == nullptr) return fail("the MQTT client cannot be made");
  set_callbacks(library.client);
  const std::string place = request.host + ":" + std::to_string(request.port);
  if (mosquitto_connect(library.client, request.host.c_str(), request.port, 15) != MOSQ_ERR_SUCCESS)
    return fail("--broker: expected an MQTT broker at " + place + ", found none");
  const double begin = client_clock();
  constexpr double kVehiclePatience = 10.0;  // until the vehicle must have been seen [s]
  while (!state.result) {
    constexpr int kWait = 100;  // [ms]
    if (mosquitto_loop(library.client, kWait, 1) != MOSQ_ERR_SUCCESS)
      return fail("--broker: the connection to " + place + " is lost" +
                  (state.refusal.empty() ? "" : ": " + state.refusal));
    const double waited = client_clock() - begin;
    if (state.seen && !state.sent) {
      const std::string text = state.message.dump(-1, ' ', false, json::error_handler_t::replace);
      const std::string path = topic_path(request.vehicle, *topic);
      mosquitto_publish(library.client, nullptr, path.c_str(), static_cast<int>(text.size()),
                        text.data(), 0, false);
      state.sent = true;
    }
    if (!state.seen && waited > kVehiclePatience)
      return fail("no vehicle publishes on " + state.state_topic + " at " + place);
    if (waited > request.patience)
      return ClientResult{.done = false, .text = "not done in time", .last_state = nullptr};
  }
  mosquitto_disconnect(library.client);
  return *state.result;
}

}  // namespace fairway::vda5050
