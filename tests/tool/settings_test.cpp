// SPDX-License-Identifier: Apache-2.0
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

TEST(Settings, TakeTheLastOfPresetFileAndAssignment) {
  const TemporaryFolder folder;
  folder.write("s.yaml", "mpc: {horizon: 11, linear_max: 0.5}\n");
  const ToolRun run =
      run_tool(folder, "settings --preset paper --settings s.yaml --set robot.linear_max=0.7");
  EXPECT_NE(run.out.find("  horizon: 11 "), std::string::npos);
  EXPECT_NE(run.out.find("  linear_max: 0.7 "), std::string::npos);
  EXPECT_NE(run.out.find("  method: mdsrc "), std::string::npos);
}

TEST(Settings, SurviveAReaderThatGoesAway) {
  const TemporaryFolder folder;
  const ToolRun run = run_tool(folder, "settings | head -n 1");
  EXPECT_EQ(count_lines(run.out), 1);
  EXPECT_EQ(run.err, "");
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
