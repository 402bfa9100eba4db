// SPDX-License-Identifier: Apache-2.0
// The orders of the shared data, driven in the workshop. Without the data the tests skip;
// driver_test.cpp holds twins that always run.
#include <filesystem>
#include <fstream>

#include "fairway/io/maps/map_file.hpp"
#include "simulated_run.hpp"

namespace fairway::vda5050::test {
namespace {

const std::filesystem::path kExamples =
    std::filesystem::path(FAIRWAY_SHARED_DATA) / "vda5050" / "examples";

json example(ProtocolVersion version, const std::string& name) {
  const char* folder = is_v3(version) ? "3.0.0" : "2.1.0";
  std::ifstream file(kExamples / folder / (name + ".json"));
  return json::parse(std::string{std::istreambuf_iterator<char>(file), {}});
}

class DrivenExamples : public testing::TestWithParam<ProtocolVersion> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kExamples)) GTEST_SKIP() << "no shared data";
    const auto map =
        io::read_map(std::string(FAIRWAY_SOURCE_DIR) + "/scenarios/maps/workshop.yaml");
    ASSERT_TRUE(map) << map.error().message;
    run.emplace(GetParam(), Pose2{{2.0, 4.4}, 0.0}, *map, Sensing::Map, std::nullopt, "workshop");
  }

  void drive(const std::string& name, const std::string& last) {
    run->send(Topic::Order, example(GetParam(), name));
    ASSERT_FALSE(run->vehicle.order().nodes.empty())
        << (run->vehicle.state().errors.empty() ? "" : run->vehicle.state().errors[0].description);
    run->until([&] { return run->vehicle.state().last_node_id == last && !run->driving(); }, 90.0);
    EXPECT_TRUE(run->vehicle.state().errors.empty());
    EXPECT_LE(run->outside, 0.03);
  }

  std::optional<SimulatedRun> run;
};

INSTANTIATE_TEST_SUITE_P(Versions,
                         DrivenExamples,
                         testing::Values(ProtocolVersion::V2_1_0, ProtocolVersion::V3_0_0));

TEST_P(DrivenExamples, WithCorridors) {
  drive("order_corridors", "goal");
  EXPECT_EQ(run->stops, 1);
}

TEST_P(DrivenExamples, WithCurves) {
  drive("order_nurbs", "door_e");
  EXPECT_EQ(run->stops, 1);
}

TEST_P(DrivenExamples, WithABaseThatGrows) {
  drive("order_base_and_horizon", "hall");
  drive("order_extension", "door_e");
}

TEST_P(DrivenExamples, WithLanesOrWithoutLines) {
  if (run->messages.third()) return drive("order_free", "goal");
  drive("order_lanes", "goal");
}

TEST_P(DrivenExamples, PastTheBlockInTheLane) {
  if (run->messages.third()) GTEST_SKIP() << "version 3 has no such example";
  drive("order_corridor_round_obstacle", "head");
}

}  // namespace
}  // namespace fairway::vda5050::test
