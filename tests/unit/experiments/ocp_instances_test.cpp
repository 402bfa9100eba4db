// SPDX-License-Identifier: Apache-2.0
#include "experiments/solver/ocp_instances.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "fairway/mpc/evaluation.hpp"
#include "fairway/mpc/interior_point/solver.hpp"
#include "support/runs/temporary_folder.hpp"

namespace fairway::io {
namespace {

const std::string kHead = "7 tight 1  1 2 0.5  3 4 0.25  5 6 -3.5  1.5 2.5 0.75  -1 -2 3 4  ";
const std::string kLine = kHead + "8 9 0.5 -0.25\n";

TEST(OcpInstances, ReadsEveryFieldOfALine) {
  const auto instances = parse_ocp_instances(kLine, "f");
  ASSERT_TRUE(instances) << instances.error().message;
  ASSERT_EQ(instances->size(), 1U);
  const OcpInstance& i = instances->front();
  EXPECT_EQ(i.id, 7);
  EXPECT_EQ(i.kind, "tight");
  EXPECT_EQ(i.start.position, Eigen::Vector2d(1, 2));
  EXPECT_EQ(i.start.heading, 0.5);
  EXPECT_EQ(i.current_target.position, Eigen::Vector2d(3, 4));
  EXPECT_EQ(i.next_target.heading, -3.5) << "not wrapped";
  EXPECT_EQ(i.rectangle.seed, Eigen::Vector2d(1.5, 2.5));
  EXPECT_EQ(i.rectangle.orientation, 0.75);
  EXPECT_EQ(i.rectangle.min, Eigen::Vector2d(-1, -2));
  EXPECT_EQ(i.rectangle.max, Eigen::Vector2d(3, 4));
  ASSERT_EQ(i.obstacles.size(), 1U);
  EXPECT_EQ(i.obstacles[0].position, Eigen::Vector2d(8, 9));
  EXPECT_EQ(i.obstacles[0].velocity, Eigen::Vector2d(0.5, -0.25));
  EXPECT_EQ(i.obstacles[0].radius, 0.8);
}

TEST(OcpInstances, BecomeThePapersProblem) {
  const ControlProblem problem = control_problem(parse_ocp_instances(kLine, "f")->front());
  EXPECT_EQ(validate(problem), ProblemFault::None);
  EXPECT_EQ(problem.horizon, 10);
  EXPECT_EQ(problem.regions[1].rectangles[0].min, Eigen::Vector2d(-0.7, -1.7));
  EXPECT_EQ(problem.obstacles[0].keep_out[3], 0.8);
  EXPECT_NEAR(problem.obstacles[0].position[10].x(), 8.5, 1e-12);
  EXPECT_FALSE(problem.penalise_first_change);
}

TEST(OcpInstances, SkipsEmptyLinesAndCarriageReturns) {
  const auto instances = parse_ocp_instances("\n\r\n" + kLine + "\t \n" + kLine, "f");
  ASSERT_TRUE(instances);
  EXPECT_EQ(instances->size(), 2U);
}

TEST(OcpInstances, AnErrorNamesFileLineAndField) {
  struct Case {
    std::string text;
    std::string message;
  };
  const std::vector<Case> cases{
      {"", "f: expected at least one line, found none"},
      {" \n\n", "f: expected at least one line, found none"},
      {kLine + "x" + kLine, "f:2: id: expected an integer, found 'x7'"},
      {"7 tight", "f:1: nobs: expected an integer, found nothing"},
      {"7 tight -1", "f:1: nobs: expected 0 to 16, found -1"},
      {"7 tight 17", "f:1: nobs: expected 0 to 16, found 17"},
      {"7 tight 0 1 2", "f:1: expected 19 fields for nobs = 0, found 5"},
      {"\n" + kHead + "8 9 0.5", "f:2: expected 23 fields for nobs = 1, found 22"},
      {kHead + "8 9 0.5 1 2", "f:1: expected 23 fields for nobs = 1, found 24"},
      {kHead + "8 9 0.5 nan", "f:1: vy: expected a number, found 'nan'"},
      {kHead + "8 9 0.5 1e999", "f:1: vy: expected a number, found '1e999'"},
      {kHead + "8 9 0x1 1", "f:1: vx: expected a number, found '0x1'"},
      {"1 free 0  0 0 0  0 0 0  0 0 0  0 0 0  1 1 -1 2",
       "f:1: xl yl xr yr: expected xl <= xr and yl <= yr, found the opposite"},
  };
  for (const Case& c : cases) {
    const auto instances = parse_ocp_instances(c.text, "f");
    ASSERT_FALSE(instances) << c.text;
    EXPECT_EQ(instances.error().message, c.message);
  }
}

OcpResult some_result(int id) {
  OcpResult result{.id = id, .status = 1, .iterations = 12, .time_us = 34.5678};
  for (int k = 0; k < kOcpHorizon; ++k)
    result.commands.push_back({.linear = 1.0 / (k + 3), .angular = -1e-9 * k});
  return result;
}

TEST(OcpResults, AreReadBackToTheBit) {
  const std::vector<OcpResult> results{some_result(3), some_result(-4)};
  const auto again = parse_ocp_results(format_ocp_results(results), "f");
  ASSERT_TRUE(again) << again.error().message;
  ASSERT_EQ(again->size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ((*again)[i].id, results[i].id);
    EXPECT_EQ((*again)[i].status, 1);
    EXPECT_EQ((*again)[i].iterations, 12);
    EXPECT_EQ((*again)[i].time_us, 34.568);
    for (std::size_t k = 0; k < 10; ++k) {
      EXPECT_EQ((*again)[i].commands[k].linear, results[i].commands[k].linear);
      EXPECT_EQ((*again)[i].commands[k].angular, results[i].commands[k].angular);
    }
  }
}

TEST(OcpResults, AnErrorNamesFileLineAndField) {
  const std::string good = format_ocp_results(std::vector{some_result(1)});
  const std::string one_less = good.substr(0, good.rfind(' '));
  EXPECT_EQ(parse_ocp_results(good + one_less, "f").error().message,
            "f:2: expected 24 fields, found 23");
  EXPECT_EQ(parse_ocp_results(one_less + " inf", "f").error().message,
            "f:1: r9: expected a number, found 'inf'");
  EXPECT_EQ(parse_ocp_results("", "f").error().message,
            "f: expected at least one line, found none");
}

TEST(OcpResults, AreWrittenCompletelyOrNotAtAll) {
  const test::TemporaryFolder folder;
  const std::vector<OcpResult> results{some_result(1)};
  ASSERT_TRUE(write_ocp_results(folder.path("a.res"), results));
  EXPECT_EQ(folder.count_files(), 1U) << "no temporary file stays";
  EXPECT_EQ(test::content_of(folder.path("a.res")), format_ocp_results(results));
  EXPECT_FALSE(write_ocp_results(folder.path("missing/a.res"), results));
  EXPECT_FALSE(read_ocp_results(folder.path("missing.res")));
}

// Instances of our own, solved, written and read: the commands are feasible in the formulas. The
// shared data has the same with the best commands that are known.
TEST(OcpData, CommandsOfASolverAreFeasibleAfterAFile) {
  const test::TemporaryFolder folder;
  const auto instances = parse_ocp_instances(
      "0 free 0  0 0 0  1.5 0.2 0  3 0.4 0  0 0 0  -1 -1.5 4 1.5\n"
      "1 dyn 1  0 0 0  1.5 0.2 0  3 0.4 0  0 0 0  -1 -1.5 4 1.5  1.6 -0.6 -0.2 0.1\n"
      "2 tight 0  0.2 0.1 0.5  1 0.8 0.7  1.5 1.5 0.8  0 0 0.7  -0.9 -0.8 3 0.8\n",
      "f");
  ASSERT_TRUE(instances) << instances.error().message;
  InteriorPointSolver solver;
  std::vector<OcpResult> results;
  for (const OcpInstance& instance : *instances) {
    const MpcSolution& solution = solver.solve(control_problem(instance));
    ASSERT_EQ(solution.status, SolveStatus::Solved) << instance.id;
    results.push_back(
        {.id = instance.id,
         .status = 0,
         .iterations = solution.iterations,
         .time_us = 0.0,
         .commands = {solution.commands.begin(), solution.commands.begin() + kOcpHorizon}});
  }
  ASSERT_TRUE(write_ocp_results(folder.path("a.best"), results));
  const auto read = read_ocp_results(folder.path("a.best"));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->size(), instances->size());
  for (std::size_t i = 0; i < read->size(); ++i) {
    const ControlProblem problem = control_problem((*instances)[i]);
    MpcSolution solution;
    std::copy((*read)[i].commands.begin(), (*read)[i].commands.end(), solution.commands.begin());
    assess(problem, solution);
    EXPECT_LT(solution.max_violation, 1e-6) << i;
    EXPECT_LT(bound_violation(problem, solution.commands).max, 1e-6) << i;
  }
}

TEST(OcpData, BestKnownCommandsAreFeasibleInOurFormulas) {
  const std::string folder = std::string(FAIRWAY_SHARED_DATA) + "/ocp/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  for (const std::string name : {"inst", "inst8", "inst16", "inst_next"}) {
    const auto instances = read_ocp_instances(folder + name + ".txt");
    const auto best = read_ocp_results(folder + name + ".best");
    ASSERT_TRUE(instances) << instances.error().message;
    ASSERT_TRUE(best) << best.error().message;
    ASSERT_EQ(instances->size(), best->size());
    for (std::size_t i = 0; i < best->size(); ++i) {
      ASSERT_EQ((*instances)[i].id, (*best)[i].id);
      if ((*best)[i].status != 0) continue;
      const ControlProblem problem = control_problem((*instances)[i]);
      MpcSolution solution;
      std::copy((*best)[i].commands.begin(), (*best)[i].commands.end(), solution.commands.begin());
      assess(problem, solution);
      EXPECT_LT(solution.max_violation, 1e-6) << name << ' ' << i;
      EXPECT_LT(bound_violation(problem, solution.commands).max, 1e-6) << name << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace fairway::io
