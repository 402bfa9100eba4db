// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <gtest/gtest.h>

#include "support/worlds/small_barn.hpp"
#include "tool_run.hpp"

namespace fairway::test {
namespace {

// The worlds of the data set, and two small ones that are always there.
enum class BarnData { Generated, Shared };

class Barn : public testing::TestWithParam<BarnData> {
 protected:
  void SetUp() override {
    if (GetParam() == BarnData::Generated) {
      write_small_barn(generated_);
    } else if (!std::filesystem::exists(FAIRWAY_SHARED_DATA "/barn/barn.json")) {
      GTEST_SKIP() << "no barn in " << FAIRWAY_SHARED_DATA;
    }
  }

  [[nodiscard]] std::string barn() const {
    return "barn '" +
           (GetParam() == BarnData::Generated ? generated_.path("")
                                              : std::string(FAIRWAY_SHARED_DATA "/barn")) +
           "' ";
  }

  [[nodiscard]] std::uintmax_t size(const char* name) const {
    std::error_code missing;
    const auto bytes = std::filesystem::file_size(folder_.path(name), missing);
    return missing ? 0 : bytes;
  }

  TemporaryFolder folder_;

 private:
  TemporaryFolder generated_;
};

TEST_P(Barn, RecordsSeveralRunsUnderTheirNamesAndOneUnderTheGivenName) {
  const ToolRun two = run_tool(folder_, barn() + "--worlds 0,6 --log r.mcap --report r.html");
  EXPECT_EQ(two.code, 0) << two.err;
  for (const char* name : {"r_world_000_trial_0.mcap", "r_world_006_trial_0.html"})
    EXPECT_GT(size(name), 10'000U) << name;
  const ToolRun one = run_tool(folder_, barn() +
                                            "--worlds 0 --sensing lidar --noise standard "
                                            "--log one.mcap");
  EXPECT_EQ(one.code, 0) << one.err;
  const ToolRun replay = run_tool(folder_, "replay one.mcap");
  EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
}

// A robot that is too wide for the passage fails, and a page shows why.
TEST_P(Barn, KeepsAPictureAndAPageOfAFailedRunOnly) {
  const ToolRun failed =
      run_tool(folder_, barn() + "--worlds 0 --set robot.radius=0.6 --trace-dir failed");
  EXPECT_EQ(failed.code, 1) << failed.err;
  EXPECT_GT(size("failed/world_000_trial_0.svg"), 1000U);
  EXPECT_GT(size("failed/world_000_trial_0.html"), 70'000U);
  const ToolRun done = run_tool(folder_, barn() + "--worlds 0 --trace-dir done");
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_GT(size("done/world_000_trial_0.csv"), 1000U);
  EXPECT_EQ(size("done/world_000_trial_0.html"), 0U);
}

TEST_P(Barn, AnUnwritableFileIsReportedBeforeTheRun) {
  const ToolRun run = run_tool(folder_, barn() + "--worlds 0 --log nowhere/r.mcap");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(count_lines(run.err), 1) << run.err;
}

INSTANTIATE_TEST_SUITE_P(Worlds,
                         Barn,
                         testing::Values(BarnData::Generated, BarnData::Shared),
                         [](const auto& data) {
                           return data.param == BarnData::Generated ? "Generated" : "Shared";
                         });

}  // namespace
}  // namespace fairway::test
