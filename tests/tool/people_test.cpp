// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tool_run.hpp"

namespace fairway::test {
namespace {

class People : public testing::Test {
 protected:
  People() {
    folder_.write(
        "cases.csv",
        "scene,case,task,start_x,start_y,goal_x,goal_y,start_frame,start_time,time_limit\n"
        "PARK,300,flow,0,0,6,0,5,0.5,10\nPARK,301,flow,0,0,6,0,5,0.5,1\n");
    folder_.write("tracks_park.csv", "frame,id,x,y,vx,vy\n5,1,3,2,0,0\n6,1,3,2,0,0\n");
    folder_.write("crowdnav_cases.csv",
                  "case,seed,agent,x,y,goal_x,goal_y\n40,1040,0,0,-4,0,4\n40,1040,1,3,0,-3,0\n");
  }

  void expect_refused(const std::string& arguments, const std::string& expected) {
    const ToolRun run = run_tool(folder_, "people " + arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_NE(run.err.find(expected), std::string::npos) << run.err;
  }

  TemporaryFolder folder_;
};

TEST_F(People, NoOutputReplacesCasesOrTracks) {
  const std::string cases = content_of(folder_.path("cases.csv"));
  for (const char* output : {"--json cases.csv", "--trace ./cases.csv", "--json tracks_park.csv",
                             "--trace crowdnav_cases.csv"})
    expect_refused(std::string("recorded . ") + output, "other than the input");
  EXPECT_EQ(content_of(folder_.path("cases.csv")), cases);
}

TEST_F(People, DriveRecordedCasesAndWriteResultAndTrace) {
  const ToolRun run = run_tool(folder_, "people recorded . --json all.json --trace all.csv");
  EXPECT_EQ(run.code, 1) << run.err << run.out;  // case 301 has too little time
  const auto json = nlohmann::json::parse(content_of(folder_.path("all.json")));
  EXPECT_EQ(json.at("success_rate"), 0.5);
  EXPECT_EQ(json.at("kinematics"), "ours");
  EXPECT_EQ(json.at("cases").at(0).at("case"), 300);
  EXPECT_EQ(json.at("cases").at(0).at("outcome"), "success");
  EXPECT_EQ(json.at("cases").at(1).at("outcome"), "timeout");
  const std::string trace = content_of(folder_.path("all.csv"));
  EXPECT_EQ(trace.rfind("case,time,x,y,heading\n300,0.000,0.0000000,0.0000000,", 0), 0U);
  EXPECT_NE(trace.find("\n301,0.000,"), std::string::npos);
}

TEST_F(People, SplitABatchAndJoinIt) {
  EXPECT_EQ(run_tool(folder_, "people recorded . --shard 1/2 --json 1.json").code, 0);
  EXPECT_EQ(run_tool(folder_, "people recorded . --shard 2/2 --json 2.json").code, 1);
  EXPECT_EQ(run_tool(folder_, "merge 2.json 1.json --json both.json").code, 0);
  const auto both = nlohmann::json::parse(content_of(folder_.path("both.json")));
  EXPECT_EQ(both.at("success_rate"), 0.5);
  EXPECT_EQ(both.at("cases").at(0).at("case"), 300);
  // Means are over successes, of which the second part has none.
  run_tool(folder_, "people recorded . --json all.json");
  const auto all = nlohmann::json::parse(content_of(folder_.path("all.json")));
  EXPECT_EQ(both.at("mean_time"), all.at("mean_time"));
}

TEST_F(People, DriveSimulatedCases) {
  const ToolRun run = run_tool(folder_, "people crowdnav . --cases 40 --json -");
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json.at("cases").at(0).at("case"), 40);
  EXPECT_EQ(json.at("benchmark"), "crowdnav");
}

TEST_F(People, RefuseWhatIsNoBenchmark) {
  expect_refused("other .", "BENCHMARK");
  expect_refused("recorded nowhere", "nowhere/cases.csv");
  expect_refused("recorded . --cases 7", "cases.csv: case: expected a case 7, found none");
  expect_refused("recorded . --cases x", "--cases: expected all");
  expect_refused("dsrnn .", "dsrnn_cases.csv");
  expect_refused("crowdnav . --kinematics theirs", "--kinematics: expected ours");
  expect_refused("crowdnav . --set navigation.control_period=0.2", "navigation.control_period");
  folder_.write("crowdnav_cases.csv", "case,seed,agent,x,y,goal_x\n");
  expect_refused("crowdnav .", "crowdnav_cases.csv:1: expected a column goal_y, found none");
  folder_.write("crowdnav_cases.csv", "case,seed,agent,x,y,goal_x,goal_y\n1,2,0,0,0,0,up\n");
  expect_refused("crowdnav .", "crowdnav_cases.csv:2: goal_y: expected a number");
}

}  // namespace
}  // namespace fairway::test
