// SPDX-License-Identifier: Apache-2.0
// The messages of the shared data, each with the answer that its index expects. Without the data
// the tests skip; the tests of orders and actions hold twins that always run.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include "vda5050/driving/fleet_double.hpp"

namespace fairway::vda5050::test {
namespace {

const std::filesystem::path kExamples =
    std::filesystem::path(FAIRWAY_SHARED_DATA) / "vda5050" / "examples";

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// What must have been sent before, so that the message finds the state that the index assumes.
const std::map<std::string, std::vector<std::string>> kBefore{
    {"order_extension", {"order_base_and_horizon"}},
    {"order_other_horizon", {"order_base_and_horizon", "order_extension"}},
    {"refused_update_old", {"order_base_and_horizon", "order_extension"}},
    {"refused_update_stitch", {"order_base_and_horizon"}},
    {"refused_other_order", {"order_lanes"}},
    {"instant_cancelOrder", {"order_corridors"}},
    {"instant_enableZoneSet", {"zoneSet"}},
};

// The error of each message that is refused; all others are taken.
const std::map<std::string, Fault> kFaults{
    {"order_actions", Fault::UnknownAction},
    {"bad_missing_nodes", Fault::Validation},
    {"bad_enum", Fault::Validation},
    {"bad_width", Fault::Validation},
    {"bad_node_reference", Fault::Validation},
    {"bad_edge_count", Fault::Validation},
    {"bad_release_order", Fault::Validation},
    {"bad_sequence", Fault::Validation},
    {"bad_knots", Fault::Validation},
    {"bad_map", Fault::UnknownMap},
    {"refused_start_far", Fault::StartNode},
    {"refused_corridor_blocked", Fault::NoRoute},
    {"refused_update_old", Fault::OutdatedUpdate},
    {"refused_update_stitch", Fault::Stitching},
    {"refused_other_order", Fault::OtherOrderActive},
    {"instant_unknown", Fault::InvalidAction},
    {"bad_zone_two_vertices", Fault::Validation},
    {"bad_zone_no_speed", Fault::Validation},
    {"bad_zone_crossed", Fault::Validation},
    {"bad_deviation_of_2_1", Fault::Validation},
    {"refused_first_update_id", Fault::Validation},
};

std::optional<Topic> received_topic(const std::string& name) {
  for (const Topic topic :
       {Topic::Order, Topic::InstantActions, Topic::ZoneSet, Topic::Responses}) {
    if (name == to_text(topic)) return topic;
  }
  return std::nullopt;
}

Topic topic_of_file(const std::string& stem) {
  if (stem.starts_with("instant_")) return Topic::InstantActions;
  return stem.starts_with("zoneSet") ? Topic::ZoneSet : Topic::Order;
}

Vehicle vehicle_at_home(ProtocolVersion version) {
  Vehicle vehicle({.version = version, .interface_name = {}}, {}, "workshop");
  vehicle.set_pose_setter([](const Pose2&) { return true; });
  // Stands for the planner: the order "blocked" has no path along its second edge.
  vehicle.set_route_check([](const Route& route, const std::vector<Zone>&) {
    const bool closed =
        route.legs.size() == 2 && route.legs[1].strip && route.legs[1].strip->right == 0.6;
    return closed ? std::optional<std::size_t>(1) : std::nullopt;
  });
  VehicleMotion motion;
  motion.pose.position = {2.0, 4.4};
  vehicle.update(motion, {}, 1.8e9);
  return vehicle;
}

class Examples : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kExamples / "index.json")) GTEST_SKIP() << "no shared data";
    index = json::parse(file_text(kExamples / "index.json"));
  }
  json index;
};

TEST_F(Examples, AreAnsweredAsTheIndexExpects) {
  std::size_t checked = 0;
  for (const json& entry : index) {
    const std::string file = entry["file"];
    const std::optional<Topic> topic = received_topic(entry["topic"]);
    if (!topic) continue;
    ++checked;
    const std::string stem = std::filesystem::path(file).stem();
    const ProtocolVersion version = *version_of(entry["version"].get<std::string>());
    Vehicle vehicle = vehicle_at_home(version);
    const std::filesystem::path folder = kExamples / to_text(version);
    if (const auto before = kBefore.find(stem); before != kBefore.end()) {
      for (const std::string& name : before->second) {
        const std::string text = file_text(folder / (name + ".json"));
        if (!text.empty()) vehicle.receive(topic_of_file(name), text, 1.8e9);
      }
    }
    ASSERT_TRUE(vehicle.state().errors.empty()) << file;
    vehicle.receive(*topic, file_text(kExamples / file), 1.8e9);
    const auto fault = kFaults.find(stem);
    const std::vector<VehicleError> errors = vehicle.state().errors;
    if (fault == kFaults.end()) {
      EXPECT_TRUE(errors.empty()) << file << ": " << (errors.empty() ? "" : errors[0].description);
      continue;
    }
    ASSERT_EQ(errors.size(), 1U) << file;
    EXPECT_EQ(errors[0].type, type_of(fault->second, version)) << file;
    EXPECT_FALSE(errors[0].references.empty()) << file;
  }
  EXPECT_GE(checked, 50U);
}

TEST_F(Examples, OfOutgoingMessagesHaveTheFieldsThatWeWrite) {
  for (const json& entry : index) {
    if (received_topic(entry["topic"])) continue;
    const std::string file = entry["file"];
    const ProtocolVersion version = *version_of(entry["version"].get<std::string>());
    Vehicle vehicle = vehicle_at_home(version);
    vehicle.announce(1.8e9);
    std::map<std::string, json> written;
    for (const OutgoingMessage& message : vehicle.take_messages(1.8e9))
      written[to_text(message.topic)] = json::parse(message.payload);
    const json example = json::parse(file_text(kExamples / file));
    const std::string topic = entry["topic"];
    ASSERT_TRUE(written.contains(topic)) << file;
    for (const auto& [key, value] : example.items()) {
      ASSERT_TRUE(written[topic].contains(key)) << file << ": " << key;
      EXPECT_EQ(written[topic][key].type_name(), std::string(value.type_name()))
          << file << ": " << key;
    }
  }
}

}  // namespace
}  // namespace fairway::vda5050::test
