// SPDX-License-Identifier: Apache-2.0
// Cyclone DDS's C interface as RAII values, with ROS 2's names and qualities of service.
#pragma once

#include <dds/dds.h>

#include <array>
#include <stdexcept>
#include <string>

#include "fairway_dds/message_types.hpp"

namespace fairway::dds {

/// A ROS 2 QoS profile; the history is always "keep last".
struct Quality {
  bool reliable = true;
  bool transient_local = false;  ///< late readers get the last values, as with a latched topic
  int depth = 10;
  std::string user_data;  ///< of the endpoint, for discovery; "key=value;" pairs
};

/// The profile for readers of driver topics: accepts best-effort and reliable writers.
inline const Quality kSensor{
    .reliable = false, .transient_local = false, .depth = 5, .user_data = {}};
inline const Quality kLatched{
    .reliable = true, .transient_local = true, .depth = 1, .user_data = {}};

/// A DDS entity that its owner deletes.
class Entity {
 public:
  /// @throws std::runtime_error that names `what` when the entity could not be made.
  Entity(dds_entity_t entity, const std::string& what);
  ~Entity();
  Entity(Entity&& other) noexcept;
  Entity& operator=(Entity&&) = delete;
  Entity(const Entity&) = delete;
  Entity& operator=(const Entity&) = delete;

  [[nodiscard]] dds_entity_t get() const noexcept { return entity_; }

 private:
  dds_entity_t entity_;
};

/// One node in a domain. Names are ROS 2's: "scan" in the namespace "robot_0" is the DDS topic
/// "rt/robot_0/scan"; a name with a leading slash is in no namespace. A name with two leading
/// slashes has a prefix of its own: "//rq/spinRequest" is "rq/robot_0/spinRequest".
class Participant {
 public:
  Participant(dds_domainid_t domain, std::string space);

  [[nodiscard]] std::string topic_name(const std::string& name) const;
  [[nodiscard]] dds_entity_t get() const noexcept { return participant_.get(); }

  /// Sleeps until data arrive, at most `seconds`.
  void wait(double seconds);
  void watch(dds_entity_t reader);

 private:
  std::string space_;
  Entity participant_;
  Entity waitset_;
};

[[nodiscard]] Entity make_topic(const Participant& participant,
                                const dds_topic_descriptor_t& type,
                                const std::string& name);
[[nodiscard]] Entity make_endpoint(const Participant& participant,
                                   const Entity& topic,
                                   const Quality& quality,
                                   bool reader,
                                   const std::string& name);

/// Receives messages of one topic.
template <typename Message>
class Reader {
 public:
  Reader(Participant& participant, const std::string& name, const Quality& quality)
      : topic_(make_topic(participant, descriptor<Message>(), name)),
        reader_(make_endpoint(participant, topic_, quality, true, name)) {
    participant.watch(reader_.get());
  }

  /// Calls `use` with every message that has arrived since the last call.
  template <typename Use>
  void take(Use&& use) {
    constexpr std::size_t kMost = 16;
    std::array<void*, kMost> samples{};
    std::array<dds_sample_info_t, kMost> infos{};
    for (dds_return_t count = static_cast<dds_return_t>(kMost);
         count == static_cast<dds_return_t>(kMost);) {
      samples[0] = nullptr;  // requests a loan
      count = dds_take(reader_.get(), samples.data(), infos.data(), kMost, kMost);
      for (dds_return_t i = 0; i < count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        if (infos[index].valid_data) use(*static_cast<const Message*>(samples[index]));
      }
      if (count > 0) dds_return_loan(reader_.get(), samples.data(), count);
    }
  }

  /// Takes one message into memory of the caller. @param writer  Set to the handle of its writer.
  /// @return whether there was one.
  [[nodiscard]] bool take_one(Message& message, dds_instance_handle_t& writer) {
    void* sample = &message;
    dds_sample_info_t info{};
    while (dds_take(reader_.get(), &sample, &info, 1, 1) == 1) {
      writer = info.publication_handle;
      if (info.valid_data) return true;
    }
    return false;
  }

  [[nodiscard]] dds_entity_t get() const noexcept { return reader_.get(); }

  /// Whether there is a writer.
  [[nodiscard]] bool is_written() const noexcept {
    dds_subscription_matched_status_t status{};
    return dds_get_subscription_matched_status(reader_.get(), &status) == DDS_RETCODE_OK &&
           status.current_count > 0;
  }

 private:
  Entity topic_;
  Entity reader_;
};

/// Sends messages of one topic.
template <typename Message>
class Writer {
 public:
  Writer(Participant& participant, const std::string& name, const Quality& quality)
      : topic_(make_topic(participant, descriptor<Message>(), name)),
        writer_(make_endpoint(participant, topic_, quality, false, name)) {}

  /// Never blocks for long and reports no errors: a full queue drops messages, as in ROS 2.
  void send(const Message& message) noexcept {
    static_cast<void>(dds_write(writer_.get(), &message));
  }

  [[nodiscard]] dds_entity_t get() const noexcept { return writer_.get(); }

  /// Whether there is a reader.
  [[nodiscard]] bool is_read() const noexcept {
    dds_publication_matched_status_t status{};
    return dds_get_publication_matched_status(writer_.get(), &status) == DDS_RETCODE_OK &&
           status.current_count > 0;
  }

 private:
  Entity topic_;
  Entity writer_;
};

}  // namespace fairway::dds
