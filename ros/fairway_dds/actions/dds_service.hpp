// SPDX-License-Identifier: Apache-2.0
// ROS 2's services over DDS, as rmw_cyclonedds_cpp has them: a topic for requests, one for replies,
// and in front of every message a header that names the client and numbers its requests.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <utility>

#include "fairway_dds/actions/action_types.hpp"
#include "fairway_dds/dds_topics.hpp"

namespace fairway::dds {

using ServiceHeader = rmw_cyclonedds_dds__ServiceHeader_;

/// What is known about the client that wrote a request.
enum class ClientState : std::uint8_t {
  Ready,    ///< its reader of replies is connected
  Pending,  ///< its reader of replies is not connected yet: a reply would be lost
  Gone,
  Foreign,  ///< it does not say which middleware it uses, so its header is not known
};

[[nodiscard]] ClientState state_of_client(dds_entity_t requests,
                                          dds_instance_handle_t writer,
                                          dds_entity_t replies);

/// Whether a server is connected to both topics of a client.
[[nodiscard]] bool has_server(dds_entity_t requests, dds_entity_t replies);

/// Quality of both topics of a service. @param key  "serviceid" or "clientid": it marks the two
/// endpoints that belong together.
[[nodiscard]] Quality service_quality(const Participant& participant, const std::string& key);

/// A message with memory of its own.
template <typename Message>
struct SampleDeleter {
  void operator()(Message* message) const noexcept {
    dds_sample_free(message, &descriptor<Message>(), DDS_FREE_ALL);
  }
};
template <typename Message>
using Sample = std::unique_ptr<Message, SampleDeleter<Message>>;

template <typename Message>
[[nodiscard]] Sample<Message> new_sample() {
  return Sample<Message>(static_cast<Message*>(dds_alloc(sizeof(Message))));  // zeros
}

/// Receives requests and sends replies.
template <typename Request, typename Response>
class ServiceServer {
 public:
  ServiceServer(Participant& participant, const std::string& name)
      : quality_(service_quality(participant, "serviceid")),
        requests_(participant, "//rq/" + name + "Request", quality_),
        replies_(participant, "//rr/" + name + "Reply", quality_) {}

  /// Calls `use` with every request whose client can receive a reply. Others wait for at most a
  /// second. @param now  Time on any clock [s].
  /// @return whether a request came from a client with an unknown header, which cannot be served.
  template <typename Use>
  bool take(double now, Use&& use) {
    constexpr double kLongestWait = 1.0;  // [s]
    Waiting next{.request = new_sample<Request>(), .writer = 0, .since = now};
    while (requests_.take_one(*next.request, next.writer)) {
      waiting_.push_back(std::move(next));
      next = {.request = new_sample<Request>(), .writer = 0, .since = now};
    }
    bool foreign = false;
    std::deque<Waiting> later;
    for (Waiting& waiting : std::exchange(waiting_, {})) {
      const ClientState state = state_of_client(requests_.get(), waiting.writer, replies_.get());
      foreign = foreign || state == ClientState::Foreign;
      if (state == ClientState::Ready) use(std::as_const(*waiting.request));
      const bool waits = std::abs(now - waiting.since) < kLongestWait;
      if (state == ClientState::Pending && waits) later.push_back(std::move(waiting));
    }
    waiting_ = std::move(later);
    return foreign;
  }

  void reply(const ServiceHeader& client, Response response) noexcept {
    response.header = client;
    replies_.send(response);
  }

 private:
  struct Waiting {
    Sample<Request> request;
    dds_instance_handle_t writer;
    double since;
  };

  Quality quality_;
  Reader<Request> requests_;
  Writer<Response> replies_;
  std::deque<Waiting> waiting_;
};

/// Sends requests and receives their replies.
template <typename Request, typename Response>
class ServiceClient {
 public:
  ServiceClient(Participant& participant, const std::string& name)
      : quality_(service_quality(participant, "clientid")),
        requests_(participant, "//rq/" + name + "Request", quality_),
        replies_(participant, "//rr/" + name + "Reply", quality_) {
    dds_get_instance_handle(requests_.get(), &handle_);
  }

  [[nodiscard]] bool is_served() const { return has_server(requests_.get(), replies_.get()); }

  /// Sends a request. @return its number.
  std::int64_t request(Request message) noexcept {
    message.header = {.client = handle_, .number = ++number_};
    requests_.send(message);
    return number_;
  }

  /// Calls `use` with the number and the content of every reply to this client.
  template <typename Use>
  void take(Use&& use) {
    replies_.take([&](const Response& response) {
      if (response.header.client == handle_) use(response.header.number, response);
    });
  }

 private:
  Quality quality_;
  Writer<Request> requests_;
  Reader<Response> replies_;
  dds_instance_handle_t handle_ = 0;
  std::int64_t number_ = 0;
};

}  // namespace fairway::dds
