// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tool_run.hpp"

namespace fairway::test {
namespace {

// Three instances: a target 2 m ahead in free space, and the same behind a wall at x = 0.5. The
// third robot is outside its rectangle and drives away, which has no feasible point.
const std::string kInstances =
    "3 free 0  0 0 0  2 0.1 0  3 0 0  0 0 0  -2 -2 6 2\n"
    "4 tight 1  0 0 0  2 0.1 0  3 0 0  0 0 0  -2 -2 0.8 2  0 1.5 0.1 0\n"
    "5 infeas 0  0 0 0.1  2 0 0  3 0 0  -2 0 0  -1 -1 1 1\n";

std::vector<std::vector<double>> rows_of(const std::string& text) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (double value = 0.0; fields >> value;)
      rows.back().push_back(value);
  }
  return rows;
}

class Solve : public testing::TestWithParam<const char*> {
 protected:
  ToolRun solve(const std::string& arguments) {
    folder_.write("in.txt", kInstances);
    return run_tool(folder_, "solve in.txt --solver " + std::string(GetParam()) + ' ' + arguments);
  }
  TemporaryFolder folder_;
};

TEST_P(Solve, WritesCommandsThatKeepTheConstraintsOrReportsThatTheyDoNot) {
  const ToolRun run = solve("--out out.res --repeat 2");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const auto rows = rows_of(content_of(folder_.path("out.res")));
  ASSERT_EQ(rows.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(rows[i].size(), 24U);
    EXPECT_EQ(rows[i][0], 3.0 + static_cast<double>(i));
    EXPECT_EQ(rows[i][1], i < 2 ? 0.0 : 1.0) << "status";
    EXPECT_GT(rows[i][2], 0.0) << "iterations";
    EXPECT_GT(rows[i][3], 0.0) << "time";
    double x = 0.0;
    double y = 0.0;
    double heading = i < 2 ? 0.0 : 0.1;
    double barrier = 1.5 * 1.5 - 0.64;  // of the second instance's obstacle, radius 0.8
    for (std::size_t k = 0; k < 10; ++k) {
      const double u = rows[i][4 + 2 * k];
      const double r = rows[i][5 + 2 * k];
      EXPECT_GE(u, 0.05);
      EXPECT_LE(u, 1.0);
      EXPECT_LE(std::abs(r), 1.5);
      x += 0.1 * u * std::cos(heading);
      y += 0.1 * u * std::sin(heading);
      heading += 0.1 * r;
      if (i != 1) continue;
      EXPECT_LE(x, 0.5 + 1e-6) << "0.3 m before the wall";
      const double ox = 0.01 * static_cast<double>(k + 1);
      const double next = (x - ox) * (x - ox) + (y - 1.5) * (y - 1.5) - 0.64;
      EXPECT_GE(next, 0.5 * barrier - 1e-6);
      barrier = next;
    }
    EXPECT_GT(x, i == 0 ? 0.9 : i == 1 ? 0.4 : 0.0);
  }
}

TEST_P(Solve, ReportsAsJson) {
  const ToolRun run = solve("--out out.res --starts 3 --json -");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto report = nlohmann::json::parse(run.out);
  EXPECT_EQ(report["solver"], GetParam());
  EXPECT_EQ(report["starts"], 3);
  ASSERT_EQ(report["instances"].size(), 3U);
  EXPECT_EQ(report["instances"][1]["limiting"], "corridor");
  EXPECT_EQ(report["instances"][2]["status"], "least violation");
  EXPECT_EQ(report["classes"].back()["class"], "all");
  EXPECT_EQ(report["classes"].back()["solved"], 2);
}

TEST_P(Solve, WarmStartsFromAnEarlierResult) {
  ASSERT_EQ(solve("--out first.res").code, 0);
  ASSERT_EQ(solve("--out second.res --warm first.res").code, 0);
  const auto first = rows_of(content_of(folder_.path("first.res")));
  const auto second = rows_of(content_of(folder_.path("second.res")));
  EXPECT_EQ(second[1][1], 0.0);
  EXPECT_NEAR(second[1][4], first[1][4], 1e-2);
}

#ifdef FAIRWAY_HAS_IPOPT
constexpr std::array kSolvers = {"interior_point", "ipopt"};
#else
constexpr std::array kSolvers = {"interior_point"};
#endif
INSTANTIATE_TEST_SUITE_P(Solvers, Solve, testing::ValuesIn(kSolvers));

TEST(SolveInput, BadInputGivesOneLineAndNoFile) {
  struct Case {
    std::string arguments;
    std::string part;
  };
  const TemporaryFolder folder;
  folder.write("in.txt", kInstances);
  folder.write("empty.txt", "");
  folder.write("bad.txt", kInstances + "6 free 0  0 0 zero  2 0 0  3 0 0  0 0 0  -2 -2 6 2\n");
  folder.write("short.txt", kInstances.substr(0, kInstances.size() - 3));
  const std::size_t files = folder.count_files();
  for (const Case& c : std::vector<Case>{
           {"none.txt --out o.res", "none.txt: expected a file"},
           {". --out o.res", "expected a file, found a folder"},
           {"empty.txt --out o.res", "empty.txt: expected at least one line"},
           {"bad.txt --out o.res", "bad.txt:4: psi0: expected a number, found 'zero'"},
           {"short.txt --out o.res", "short.txt:3: expected 19 fields"},
           {"in.txt", "--out"},
           {"in.txt --out no/o.res", "no/o.res: expected an existing folder"},
           {"in.txt --out o.res --solver newton", "expected interior_point or ipopt"},
           {"in.txt --out o.res --starts 0", "expected an integer from 1"},
           {"in.txt --out o.res --starts nan", "expected an integer from 1"},
           {"in.txt --out o.res --repeat 2.5", "expected an integer from 1"},
           {"in.txt --out o.res --warm in.txt", "in.txt:1: expected 24 fields"},
           {"in.txt --out o.res --json no/o.json", "no/o.json: expected an existing folder"},
           {"in.txt --out - --json -", "standard output for both"},
       }) {
    const ToolRun run = run_tool(folder, "solve " + c.arguments);
    EXPECT_EQ(run.code, 2) << c.arguments;
    EXPECT_TRUE(run.err.starts_with("fairway: ")) << run.err;
    EXPECT_NE(run.err.find(c.part), std::string::npos) << run.err;
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(folder.count_files(), files) << c.arguments;
  }
}

}  // namespace
}  // namespace fairway::test
