// SPDX-License-Identifier: Apache-2.0
#include "fairway_dds/dds_topics.hpp"

#include <utility>

namespace fairway::dds {

Entity::Entity(dds_entity_t entity, const std::string& what) : entity_(entity) {
  if (entity < 0) throw std::runtime_error(what + ": " + dds_strretcode(-entity));
}

Entity::~Entity() {
  if (entity_ > 0) dds_delete(entity_);
}

Entity::Entity(Entity&& other) noexcept : entity_(std::exchange(other.entity_, 0)) {}

Participant::Participant(dds_domainid_t domain, std::string space)
    : space_(std::move(space)),
      participant_(dds_create_participant(domain, nullptr, nullptr),
                   "DDS domain " + std::to_string(domain)),
      waitset_(dds_create_waitset(participant_.get()), "DDS waitset") {}

std::string Participant::topic_name(const std::string& name) const {
  if (name.starts_with("//")) {
    const std::size_t end = name.find('/', 2);
    return name.substr(2, end - 2) + (space_.empty() ? "" : "/" + space_) + name.substr(end);
  }
  if (name.front() == '/') return "rt" + name;
  return space_.empty() ? "rt/" + name : "rt/" + space_ + "/" + name;
}

void Participant::watch(dds_entity_t reader) {
  dds_set_status_mask(reader, DDS_DATA_AVAILABLE_STATUS);
  dds_waitset_attach(waitset_.get(), reader, 0);
}

void Participant::wait(double seconds) {
  if (seconds <= 0.0) return;
  static_cast<void>(
      dds_waitset_wait(waitset_.get(), nullptr, 0, static_cast<dds_duration_t>(seconds * 1e9)));
}

Entity make_topic(const Participant& participant,
                  const dds_topic_descriptor_t& type,
                  const std::string& name) {
  const std::string full = participant.topic_name(name);
  return {dds_create_topic(participant.get(), &type, full.c_str(), nullptr, nullptr),
          "topic " + full};
}

Entity make_endpoint(const Participant& participant,
                     const Entity& topic,
                     const Quality& quality,
                     bool reader,
                     const std::string& name) {
  constexpr dds_duration_t kLongestBlock = 100'000'000;  // [ns], ROS 2's
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos,
                       quality.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       kLongestBlock);
  dds_qset_durability(
      qos, quality.transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, quality.depth);
  if (!reader && quality.transient_local) {
    dds_qset_durability_service(qos, 0, DDS_HISTORY_KEEP_LAST, quality.depth, DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  }
  if (!quality.user_data.empty()) {
    dds_qset_userdata(qos, quality.user_data.data(), quality.user_data.size());
  }
  const dds_entity_t made = reader
                                ? dds_create_reader(participant.get(), topic.get(), qos, nullptr)
                                : dds_create_writer(participant.get(), topic.get(), qos, nullptr);
  dds_delete_qos(qos);
  return {made, (reader ? "reader of " : "writer of ") + name};
}

}  // namespace fairway::dds
