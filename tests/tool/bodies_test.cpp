// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tool_run.hpp"

namespace fairway::test {
namespace {

// A task in the room of write_room; `changes` are merged into it.
std::string task(const nlohmann::json& changes = nlohmann::json::object()) {
  nlohmann::json json = nlohmann::json::parse(R"({
    "map": "room.yaml",
    "robot": {"kind": "car", "length": 1.0, "width": 0.5, "reference_to_front": 0.8, "wheelbase": 0.6,
              "steering_max": 0.6, "steering_rate_max": 1.0, "linear_min": -0.5, "linear_max": 1.0,
              "angular_max": 1.5, "linear_acceleration": 0.8, "angular_acceleration": 3.0},
    "start": [1.5, 1.0, 0.0], "goal": [6.5, 3.0, 0.0], "time_limit": 40.0,
    "tolerances": {"position": 0.01, "heading": 0.02, "linear": 0.02, "angular": 0.02}})");
  json.merge_patch(changes);
  return json.dump();
}

class Bodies : public testing::Test {
 protected:
  Bodies() { write_room(folder_); }

  ToolRun run(const std::string& content, const std::string& options = "") {
    folder_.write("task.json", content);
    return run_tool(folder_, "bodies task.json " + options);
  }

  // Exit code 2, and one line that names the file and holds `expected`.
  void expect_refused(const std::string& content, const std::string& expected) {
    const ToolRun result = run(content);
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(count_lines(result.err), 1) << result.err;
    EXPECT_EQ(result.err.rfind("fairway: task.json", 0), 0U) << result.err;
    EXPECT_NE(result.err.find(expected), std::string::npos) << result.err;
  }

  void expect_refused_output(const std::string& content, const std::string& arguments) {
    folder_.write("task.json", content);
    const ToolRun result = run_tool(folder_, "bodies " + arguments);
    EXPECT_EQ(result.code, 2) << arguments;
    EXPECT_NE(result.err.find("--json: expected a file other than the input"), std::string::npos)
        << result.err;
  }

  TemporaryFolder folder_;
};

TEST_F(Bodies, DrivesATaskAndWritesResultAndTrace) {
  const ToolRun result = run(task(), "--json result.json --trace-dir traces");
  EXPECT_EQ(result.code, 0) << result.err << result.out;
  const auto json = nlohmann::json::parse(content_of(folder_.path("result.json")));
  EXPECT_EQ(json.at("success_rate"), 1.0);
  const auto& row = json.at("tasks").at(0);
  EXPECT_EQ(row.at("task"), "task");
  EXPECT_EQ(row.at("reason"), "arrived");
  EXPECT_GT(row.at("min_clearance"), 0.0);
  const std::string trace = content_of(folder_.path("traces/task.csv"));
  EXPECT_EQ(trace.rfind("time,robot,x,y,heading,linear,angular\n0.00,robot,1.5", 0), 0U);
}

TEST_F(Bodies, NoOutputReplacesATaskOrItsMap) {
  const std::string content = task({{"time_limit", 1.0}});
  expect_refused_output(content, "task.json --json task.json");
  expect_refused_output(content, "task.json --json room.pgm");
  expect_refused_output(content, ". --json ./task.json");
  EXPECT_EQ(content_of(folder_.path("task.json")), content);
}

TEST_F(Bodies, DrivesOneShardOfItsTasks) {
  for (const char* name : {"a.json", "b.json", "c.json"})
    folder_.write(name, task({{"time_limit", 1.0}}));
  for (const char* part : {"1/2", "2/2"}) {
    const std::string file = std::string("part") + part[0] + ".out";
    const ToolRun result =
        run_tool(folder_, std::string("bodies . --shard ") + part + " --json " + file);
    EXPECT_EQ(result.code, 1) << result.err;  // no drive takes less than a second
  }
  const ToolRun merged = run_tool(folder_, "merge part1.out part2.out");
  ASSERT_EQ(merged.code, 0) << merged.err;
  const auto json = nlohmann::json::parse(merged.out);
  EXPECT_EQ(json.at("tasks").size(), 3U);
  EXPECT_EQ(json.at("provenance").at("command").at(1), "merge");
  EXPECT_EQ(run_tool(folder_, "parking . --shard 3/2").code, 2);
}

TEST_F(Bodies, GivesTheReasonWhereThereIsNoDrive) {
  const ToolRun blocked = run(task({{"goal", {4.0, 0.5, 0.0}}}), "--json result.json");
  EXPECT_EQ(blocked.code, 1);
  const auto json = nlohmann::json::parse(content_of(folder_.path("result.json")));
  EXPECT_EQ(json.at("tasks").at(0).at("reason"), "the body does not fit at the goal");
  const ToolRun late = run(task({{"time_limit", 1.0}}));
  EXPECT_EQ(late.code, 1);
  EXPECT_NE(late.out.find("the limit is 1.00 s"), std::string::npos) << late.out;
}

TEST_F(Bodies, RefusesTasksThatAreNone) {
  expect_refused("no JSON", "expected a task as JSON");
  expect_refused(task({{"robot", {{"kind", "boat"}}}}), "robot.kind: expected unicycle, car");
  expect_refused(task({{"robot", {{"wheelbase", nullptr}}}}), "robot.wheelbase: expected a number");
  expect_refused(task({{"robot", {{"linear_max", -1}}}}), "robot.linear_max: expected a number");
  expect_refused(task({{"robot", {{"wheels", {{"type", "hover"}, {"speed_max", 1}}}}}}),
                 "robot.wheels.type: expected differential");
  expect_refused(task({{"robot", {{"footprint", {{0, 0}, {1, 1}, {0, 2}, {0.5, 1}}}}}}), "convex");
  expect_refused(task({{"start", {1.0, 2.0}}}), "start: expected 3 numbers");
  const ToolRun no_map = run(task({{"map", "none.yaml"}}));
  EXPECT_EQ(no_map.code, 2);
  EXPECT_EQ(count_lines(no_map.err), 1);
}

TEST_F(Bodies, RefusesUnknownTasksAndPhysicsThatAreNotThere) {
  EXPECT_NE(run(task(), "--tasks other").err.find("--tasks: expected a task"), std::string::npos);
  EXPECT_EQ(run(task(), "--physics gazebo").code, 2);
  EXPECT_EQ(run_tool(folder_, "bodies nowhere").code, 2);
}

// A bay between two boxes: a car beside it, as in the competition's files; far from the origin.
std::string parking_case(double shift) {
  const auto number = [](double v) { return std::to_string(v); };
  std::string text = number(shift) + ",4,0," + number(shift + 5.0) + ",0,6.283185307,2,4,4";
  for (const double x : {shift - 8.0, shift + 11.0}) {
    for (const auto& [u, v] : {std::pair(0.0, -1.0), {7.0, -1.0}, {7.0, 1.0}, {0.0, 1.0}})
      text += "," + number(x + u) + "," + number(v);
  }
  return text + "\n";
}

TEST_F(Bodies, ParksAlsoFarFromTheOrigin) {
  for (const double shift : {0.0, 5e9}) {
    folder_.write("Case2.csv", parking_case(shift));
    const ToolRun result = run_tool(folder_, "parking . --json result.json");
    EXPECT_EQ(result.code, 0) << result.err << result.out;
    const auto json = nlohmann::json::parse(content_of(folder_.path("result.json")));
    const auto& row = json.at("tasks").at(0);
    EXPECT_EQ(row.at("task"), "Case2");
    EXPECT_GT(row.at("cost"), 100.0 * row.at("time").get<double>());
    EXPECT_EQ(row.at("gear_changes"), row.at("cusps"));
  }
}

TEST_F(Bodies, RefusesParkingCasesThatAreNone) {
  for (const char* content :
       {"", "1,2,x", "0,0,0,1,1,0,1,4,0,0", "0,0,0,1,1,0,-1", "0,0,0,1,1,0,1,2,0,0,1,1"}) {
    folder_.write("Case1.csv", content);
    const ToolRun result = run_tool(folder_, "parking .");
    EXPECT_EQ(result.code, 2) << content;
    EXPECT_EQ(count_lines(result.err), 1) << result.err;
    EXPECT_NE(result.err.find("Case1.csv:1: "), std::string::npos) << result.err;
  }
}

constexpr const char* kCar =
    "kind: car\nlength: 1.0\nwidth: 0.5\nreference_to_front: 0.8\nwheelbase: 0.6\n"
    "steering_max: 0.6\nsteering_rate_max: 1.0\nlinear_min: -0.5\nlinear_max: 1.0\n"
    "angular_max: 1.5\nlinear_acceleration: 0.8\nangular_acceleration: 3.0\n";

// The plans of a body are not in the recording: the replay makes them again.
TEST_F(Bodies, ARunIsRecordedAndReplayedToTheBit) {
  folder_.write("car.yaml", kCar);
  const std::string drive =
      "simulate --map room.yaml --start 1.5,1,0 --goal 6.5,3,0 --body car.yaml ";
  for (const std::string sensing : {"map", "lidar"}) {
    const ToolRun run =
        run_tool(folder_, drive + "--sensing " + sensing + " --log run.mcap --report run.html");
    EXPECT_EQ(run.code, 0) << run.err << run.out;
    const ToolRun replay = run_tool(folder_, "replay run.mcap");
    EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
  }
  const ToolRun threads = run_tool(folder_, drive + "--set planning.background=true --log a.mcap");
  EXPECT_EQ(threads.code, 2);
  EXPECT_NE(threads.err.find("--log: expected planning.background false"), std::string::npos)
      << threads.err;
}

}  // namespace
}  // namespace fairway::test
