// SPDX-License-Identifier: Apache-2.0
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

#include "tool_run.hpp"

namespace fairway::test {
namespace {

TEST(Settings, ArePrintedAsAFileThatReadsBackTheSame) {
  const TemporaryFolder folder;
  for (const std::string options : {"", " --preset paper", " --set robot.linear_max=0.123456789"}) {
    const ToolRun first = run_tool(folder, "settings" + options);
    ASSERT_EQ(first.code, 0) << first.err;
    folder.write("s.yaml", first.out);
    const ToolRun second = run_tool(folder, "settings --settings s.yaml");
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_EQ(second.out, first.out);
  }
}

TEST(Settings, ApplyPresetThenFileThenAssignment) {
  const TemporaryFolder folder;
  folder.write("s.yaml", "mpc: {horizon: 11, linear_max: 0.5}\n");
  const ToolRun run =
      run_tool(folder, "settings --preset paper --settings s.yaml --set robot.linear_max=0.7");
  EXPECT_NE(run.out.find("  horizon: 11 "), std::string::npos);
  EXPECT_NE(run.out.find("  linear_max: 0.7 "), std::string::npos);
  EXPECT_NE(run.out.find("  method: mdsrc "), std::string::npos);
}

TEST(Settings, SurviveAClosedPipe) {
  const TemporaryFolder folder;
  const ToolRun run = run_tool(folder, "settings | head -n 1");
  EXPECT_EQ(count_lines(run.out), 1);
  EXPECT_EQ(run.err, "");
}

TEST(Settings, EssentialOnesArePrintedAlone) {
  const TemporaryFolder folder;
  const ToolRun run = run_tool(folder, "settings --essential --set robot.linear_max=0.7");
  ASSERT_EQ(run.code, 0) << run.err;
  std::vector<std::string> names;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line[0] != '#') names.push_back(line.substr(0, line.find(':')));
  }
  const std::vector<std::string> expected = {"robot",
                                             "  radius",
                                             "  length",
                                             "  width",
                                             "  linear_min",
                                             "  linear_max",
                                             "  angular_max",
                                             "  linear_acceleration_max",
                                             "  angular_acceleration_max",
                                             "  linear_braking_max",
                                             "  linear_delay",
                                             "  angular_delay",
                                             "  linear_lag",
                                             "  angular_lag",
                                             "prediction",
                                             "  obstacle_margin",
                                             "safety",
                                             "  longest_hold",
                                             "  stop_margin",
                                             "navigation",
                                             "  control_period",
                                             "  goal_tolerance"};
  EXPECT_EQ(names, expected);
  // Each line is one of `fairway settings`, and the text is a file to start from.
  const ToolRun all = run_tool(folder, "settings --set robot.linear_max=0.7");
  EXPECT_NE(all.out.find(run.out.substr(run.out.find("  linear_max: 0.7 "), 90)),
            std::string::npos);
  folder.write("s.yaml", run.out);
  EXPECT_EQ(run_tool(folder, "settings --settings s.yaml").out, all.out);
}

TEST(Settings, WarnOnceAboutAllOldNames) {
  const TemporaryFolder folder;
  folder.write("s.yaml", "mpc: {dt: 0.1, linear_max: 0.5}\n");
  const ToolRun run =
      run_tool(folder, "settings --settings s.yaml --set mpc.dt=0.2 --set navigation.pose_jump=1");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err,
            "fairway: warning: these settings have new names; the old ones work until 1.0: "
            "mpc.dt (now mpc.step_length and navigation.control_period), mpc.linear_max (now "
            "robot.linear_max), navigation.pose_jump (now safety.pose_jump)\n");
  EXPECT_NE(run.out.find("  control_period: 0.2 "), std::string::npos);
}

TEST(Settings, WarnAboutOldNamesInAScenario) {
  const TemporaryFolder folder;
  write_room(folder);
  folder.write("s.yaml",
               "map: room.yaml\nsettings: {navigation: {blocked_after: 3}}\n"
               "robots:\n  - {start: [1, 2, 0], goal: [3, 2]}\n");
  const ToolRun run = run_tool(folder, "simulate s.yaml");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err,
            "fairway: warning: these settings have new names; the old ones work until 1.0: "
            "navigation.blocked_after (now navigation.stall_timeout)\n");
}

TEST(Settings, ABadInputIsTheOnlyMessageDespiteOldNames) {
  const TemporaryFolder folder;
  folder.write("s.yaml", "mpc: {dt: 0.1}\n");
  const ToolRun run =
      run_tool(folder, "settings --settings s.yaml --set mpc.dt=0.2 --set robot.radius=-1");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.err,
            "fairway: --set: robot.radius: expected a number from 0.01 to 10, found '-1'\n");
  EXPECT_EQ(run.out, "");
}

TEST(Tool, ExplainsItself) {
  const TemporaryFolder folder;
  for (const char* arguments : {"--help", "plan --help", "simulate --help", "settings --help"}) {
    const ToolRun run = run_tool(folder, arguments);
    EXPECT_EQ(run.code, 0) << arguments;
    EXPECT_EQ(run.err, "") << arguments;
    EXPECT_GT(count_lines(run.out), 5) << arguments;
  }
  EXPECT_TRUE(run_tool(folder, "--version").out.starts_with("fairway "));
  EXPECT_EQ(run_tool(folder, "--version").code, 0);
}

}  // namespace
}  // namespace fairway::test
