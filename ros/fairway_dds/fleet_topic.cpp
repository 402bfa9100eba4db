// SPDX-License-Identifier: Apache-2.0
#include "fairway_dds/fleet_topic.hpp"

#include <cstdio>
#include <utility>

#include "fairway/base/utf8_text.hpp"
#include "fairway_dds/dds_conversions.hpp"

namespace fairway::dds {

FleetTopic::FleetTopic(Participant& participant, std::string name)
    : name_(std::move(name)),
      others_(participant, "/fairway/fleet", {.reliable = false, .depth = 50}),
      own_(participant, "/fairway/fleet", {.reliable = false, .depth = 1}) {}

void FleetTopic::take(bridge::FleetBoard& fleet, const SensorTopics& sensors, double now) {
  others_.take([&](const fairway_msgs_msg_dds__SharedMotion_& message) {
    take_robot(message, fleet, sensors.find_frame(message.header.frame_id), now);
  });
}

void FleetTopic::take_robot(const fairway_msgs_msg_dds__SharedMotion_& message,
                            bridge::FleetBoard& fleet,
                            const std::optional<Pose2>& frame,
                            double now) {
  const std::string name = message.name;
  if (name_.empty() || name == name_) return;
  if (message.leaving) {
    fleet.forget(name);
    if (robots_.erase(name) > 0)
      std::fprintf(stderr, "fairway: robot %s has left\n", one_line(name).c_str());
  } else if (frame) {
    if (!fleet.receive(name, to_motion(message, *frame), now)) {
      std::fprintf(stderr, "fairway: %s: expected a plausible message with a time that has been\n",
                   one_line(name).c_str());
    } else if (robots_.insert(name).second) {
      std::fprintf(stderr, "fairway: receives robot %s\n", one_line(name).c_str());
    }
  }
}

void FleetTopic::send(const SharedMotion& motion, const std::string& frame, bool leaving) {
  if (!name_.empty()) own_.send(MotionMessage(motion, name_, frame, leaving).get());
}

}  // namespace fairway::dds
