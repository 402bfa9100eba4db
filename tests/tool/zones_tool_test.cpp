// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tool_run.hpp"

namespace fairway::test {
namespace {

using Json = nlohmann::json;

constexpr const char* kRoomPlan = "plan room.yaml --start 1,2 --goal 7,2 --set robot.radius=0.2 ";

class ZoneFiles : public testing::Test {
 protected:
  ZoneFiles() { write_room(folder_); }

  ToolRun plan(const std::string& zones) {
    folder_.write("zones.yaml", zones);
    return run_tool(folder_, std::string(kRoomPlan) + "--zones zones.yaml --json out.json");
  }

  void expect_refused(const std::string& zones, const std::string& part) {
    const ToolRun run = plan(zones);
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
  }

  TemporaryFolder folder_;
};

TEST_F(ZoneFiles, FaultsAreNamedWithFileAndLine) {
  expect_refused("zones:\n  - {kind: keepout, polygon: [[1, 1], [2, 1], [2, 2]]}\n",
                 "zones.yaml:2: zones[0].kind: expected keep_out");
  expect_refused("zones:\n  - {kind: keep_out, polygon: [[1, 1], [2, 1]]}\n",
                 "zones[0].polygon: expected 3 to 1000 corners, found 2");
  expect_refused("zones:\n  - {kind: strip, polygon: [[1, 1], [3, 2], [3, 1], [1, 3]]}\n",
                 "zones[0].polygon: expected edges that do not cross");
  expect_refused("zones:\n  - {kind: speed_limit, polygon: [[1, 1], [2, 1], [2, 2]]}\n",
                 "zones[0].speed: expected a number");
  expect_refused("zones: 3\n", "zones: expected a list");
  expect_refused("", "zones.yaml");
}

TEST_F(ZoneFiles, APlanLeadsAroundAKeepOut) {
  const ToolRun run =
      plan("zones:\n  - {kind: keep_out, polygon: [[2, 1.2], [3, 1.2], [3, 3], [2, 3]]}\n");
  ASSERT_EQ(run.code, 0) << run.err;
  const Json answer = Json::parse(content_of(folder_.path("out.json")));
  double lowest = 2.0;
  for (const Json& point : answer.at("path"))
    lowest = std::min(lowest, point.at(1).get<double>());
  EXPECT_LT(lowest, 1.01);
}

TEST_F(ZoneFiles, ZonesThatLeaveNoPathAreTheReason) {
  const ToolRun closed =
      plan("zones:\n  - {kind: keep_out, polygon: [[4, -1], [5, -1], [5, 9], [4, 9]]}\n");
  EXPECT_EQ(closed.code, 1);
  EXPECT_NE(closed.err.find("no path that the zones allow"), std::string::npos) << closed.err;
  const ToolRun goal =
      plan("zones:\n  - {kind: keep_out, name: pit, polygon: [[6, 1], [8, 1], [8, 3], [6, 3]]}\n");
  EXPECT_EQ(goal.code, 1);
  EXPECT_NE(goal.err.find("the goal (7.00, 2.00) is 0.000 m from the keep-out zone"),
            std::string::npos)
      << goal.err;
  EXPECT_NE(goal.err.find("pit"), std::string::npos) << goal.err;
}

TEST_F(ZoneFiles, ARunReportsHowItKeptThem) {
  folder_.write("run.yaml",
                "map: room.yaml\ntime_limit: 60\nsettings: {robot: {radius: 0.2}}\n"
                "robots: [{start: [1, 2, 0], goal: [7, 2]}]\n"
                "zones:\n  - {kind: speed_limit, speed: 0.3, "
                "polygon: [[3, 0], [5, 0], [5, 4], [3, 4]]}\n");
  const ToolRun run = run_tool(folder_, "simulate run.yaml --json out.json --log run.mcap");
  ASSERT_EQ(run.code, 0) << run.err;
  const Json zones =
      Json::parse(content_of(folder_.path("out.json"))).at("robots").at(0).at("zones");
  EXPECT_LE(zones.at("excess").get<double>(), 1e-3);
  EXPECT_EQ(zones.at("intrusion").get<double>(), 0.0);
  const ToolRun replay = run_tool(folder_, "replay run.mcap");
  EXPECT_EQ(replay.code, 0) << replay.err;
  EXPECT_NE(replay.out.find("the same to the bit"), std::string::npos) << replay.out;
}

}  // namespace
}  // namespace fairway::test
