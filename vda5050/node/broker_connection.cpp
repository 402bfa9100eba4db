// SPDX-License-Identifier: Apache-2.0
#include "node/broker_connection.hpp"

#include <mosquitto.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace fairway::vda5050 {

namespace {

constexpr int kKeepAlive = 15;  // [s], as the standard suggests

void check(int result, const char* what) {
  if (result != MOSQ_ERR_SUCCESS)
    throw std::runtime_error(std::string(what) + ": " + mosquitto_strerror(result));
}

const char* text_or_null(const std::string& text) { return text.empty() ? nullptr : text.c_str(); }

}  // namespace

struct Wakeup::State {
  std::mutex mutex;
  std::condition_variable condition;
  bool news = false;
};

Wakeup::Wakeup() : state_(std::make_unique<State>()) {}
Wakeup::~Wakeup() = default;

void Wakeup::notify() noexcept {
  {
    const std::lock_guard lock(state_->mutex);
    state_->news = true;
  }
  state_->condition.notify_one();
}

void Wakeup::wait(double seconds) {
  std::unique_lock lock(state_->mutex);
  state_->condition.wait_for(lock, std::chrono::duration<double>(seconds),
                             [this] { return state_->news; });
  state_->news = false;
}

struct BrokerConnection::State {
  BrokerAddress address;
  VehicleIdentity identity;
  Wakeup& wakeup;
  mosquitto* client = nullptr;
  bool started = false;
  std::array<std::pair<Topic, std::string>, 4> topics{};  // received from the fleet control

  mutable std::mutex mutex;  // guards what follows
  std::condition_variable sent;
  std::vector<BrokerEvent> events;
  bool connected = false;
  int awaited = -1;  // message whose arrival at the broker is awaited

  State(const BrokerAddress& broker, const VehicleIdentity& vehicle, Wakeup& news)
      : address(broker),
        identity(vehicle),
        wakeup(news) {
    std::size_t i = 0;
    for (const Topic topic :
         {Topic::Order, Topic::InstantActions, Topic::ZoneSet, Topic::Responses})
      topics.at(i++) = {topic, topic_path(identity, topic)};
  }

  void add(BrokerEvent event) {
    {
      const std::lock_guard lock(mutex);
      events.push_back(std::move(event));
    }
    wakeup.notify();
  }

  // The callbacks run in the library's thread.
  void on_connect(int code) {
    if (code != 0) {
      add({.kind = BrokerEvent::Kind::Refused, .payload = mosquitto_connack_string(code)});
      return;
    }
    std::array<char*, 4> names{};
    for (std::size_t i = 0; i < names.size(); ++i)
      names.at(i) = topics.at(i).second.data();
    mosquitto_subscribe_multiple(client, nullptr, static_cast<int>(names.size()), names.data(), 0,
                                 0, nullptr);
  }

  void on_subscribe() {
    {
      const std::lock_guard lock(mutex);
      connected = true;
    }
    add({.kind = BrokerEvent::Kind::Ready, .payload = {}});
  }

  void on_disconnect() {
    bool was = false;
    {
      const std::lock_guard lock(mutex);
      was = std::exchange(connected, false);
    }
    sent.notify_all();
    if (was) add({.kind = BrokerEvent::Kind::Lost, .payload = {}});
  }

  void on_message(const mosquitto_message& message) {
    for (const auto& [topic, path] : topics) {
      if (path != message.topic) continue;
      const auto length = static_cast<std::size_t>(message.payloadlen);
      add({.topic = topic,
           .payload = std::string(static_cast<const char*>(message.payload), length)});
    }
  }

  void on_publish(int id) {
    {
      const std::lock_guard lock(mutex);
      if (id != awaited) return;
      awaited = -1;
    }
    sent.notify_all();
  }
};

BrokerConnection::BrokerConnection(const BrokerAddress& address,
                                   const VehicleIdentity& identity,
                                   const OutgoingMessage& will,
                                   Wakeup& wakeup)
    : state_(std::make_unique<State>(address, identity, wakeup)) {
  State* const state = state_.get();
  state->client = mosquitto_new(nullptr, true, state);
  if (state->client == nullptr) throw std::runtime_error("the MQTT client cannot be made");
  mosquitto* const client = state->client;
  // Messages are small: none waits for the acknowledgement of the one before it.
  check(mosquitto_int_option(client, MOSQ_OPT_TCP_NODELAY, 1), "option");
  const std::string topic = topic_path(identity, will.topic);
  check(mosquitto_will_set(client, topic.c_str(), static_cast<int>(will.payload.size()),
                           will.payload.data(), will.qos, will.retained),
        "last will");
  if (!address.user.empty()) {
    check(mosquitto_username_pw_set(client, address.user.c_str(), text_or_null(address.password)),
          "user name");
  }
  if (!address.ca_file.empty()) {
    check(
        mosquitto_tls_set(client, address.ca_file.c_str(), nullptr, text_or_null(address.cert_file),
                          text_or_null(address.key_file), nullptr),
        "TLS files");
  }
  mosquitto_reconnect_delay_set(client, 1, 5, true);
  mosquitto_connect_callback_set(client, [](mosquitto*, void* self, int code) {
    static_cast<State*>(self)->on_connect(code);
  });
  mosquitto_subscribe_callback_set(client, [](mosquitto*, void* self, int, int, const int*) {
    static_cast<State*>(self)->on_subscribe();
  });
  mosquitto_disconnect_callback_set(
      client, [](mosquitto*, void* self, int) { static_cast<State*>(self)->on_disconnect(); });
  mosquitto_message_callback_set(client,
                                 [](mosquitto*, void* self, const mosquitto_message* message) {
                                   static_cast<State*>(self)->on_message(*message);
                                 });
  mosquitto_publish_callback_set(
      client, [](mosquitto*, void* self, int id) { static_cast<State*>(self)->on_publish(id); });
}

BrokerConnection::~BrokerConnection() {
  if (state_->started) {
    mosquitto_disconnect(state_->client);
    mosquitto_loop_stop(state_->client, true);
  }
  mosquitto_destroy(state_->client);
}

void BrokerConnection::start() {
  // The thread of the library tries again while the broker is not there.
  (void)mosquitto_connect_async(state_->client, state_->address.host.c_str(), state_->address.port,
                                kKeepAlive);
  check(mosquitto_loop_start(state_->client), "MQTT thread");
  state_->started = true;
}

void BrokerConnection::publish(const OutgoingMessage& message) {
  if (!connected()) return;
  const std::string topic = topic_path(state_->identity, message.topic);
  (void)mosquitto_publish(state_->client, nullptr, topic.c_str(),
                          static_cast<int>(message.payload.size()), message.payload.data(),
                          message.qos, message.retained);
}

void BrokerConnection::finish(const OutgoingMessage& last, double seconds) {
  if (!state_->started) return;
  if (connected()) {
    const std::string topic = topic_path(state_->identity, last.topic);
    std::unique_lock lock(state_->mutex);
    int id = -1;
    // The callback takes the lock, so it cannot come before `awaited` is set.
    const int result =
        mosquitto_publish(state_->client, &id, topic.c_str(), static_cast<int>(last.payload.size()),
                          last.payload.data(), 1, last.retained);
    if (result == MOSQ_ERR_SUCCESS) {
      state_->awaited = id;
      state_->sent.wait_for(lock, std::chrono::duration<double>(seconds),
                            [this] { return state_->awaited < 0 || !state_->connected; });
    }
  }
  // The thread must send DISCONNECT before it ends: otherwise the broker would publish the will.
  const bool orderly = connected();
  mosquitto_disconnect(state_->client);
  mosquitto_loop_stop(state_->client, !orderly);
  state_->started = false;
}

std::vector<BrokerEvent> BrokerConnection::take_events() {
  const std::lock_guard lock(state_->mutex);
  return std::exchange(state_->events, {});
}

bool BrokerConnection::connected() const {
  const std::lock_guard lock(state_->mutex);
  return state_->connected;
}

MqttLibrary::MqttLibrary() { mosquitto_lib_init(); }
MqttLibrary::~MqttLibrary() { mosquitto_lib_cleanup(); }

}  // namespace fairway::vda5050
