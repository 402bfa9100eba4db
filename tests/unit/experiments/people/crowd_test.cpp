// SPDX-License-Identifier: Apache-2.0
#include "experiments/people/crowd.hpp"

#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "experiments/people/csv_table.hpp"
#include "experiments/people/people_files.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

std::string shared() { return std::string(FAIRWAY_SHARED_DATA) + "/social"; }

bool has_shared() { return std::filesystem::exists(shared() + "/cases.csv"); }

TEST(Crowd, DrawsTheSharedStarts) {
  if (!has_shared()) GTEST_SKIP() << "no shared data";
  for (const CrowdBenchmark benchmark :
       {CrowdBenchmark::CrowdNav, CrowdBenchmark::DsRnn, CrowdBenchmark::CrowdNavPlus}) {
    const auto cases = io::read_crowd_cases(shared(), benchmark, {});
    ASSERT_TRUE(cases) << cases.error().message;
    EXPECT_EQ(cases->size(), 250U);
    for (const CrowdCase& one : *cases) {
      EXPECT_EQ(one.seed, crowd_seed(benchmark, one.number));
      const CrowdCase made = draw_case(benchmark, one.number, one.seed);
      EXPECT_LT((made.start.position - one.start.position).norm(), 1e-12);
      EXPECT_LT((made.goal - one.goal).norm(), 1e-12);
      ASSERT_EQ(made.people.size(), one.people.size());
      for (std::size_t i = 0; i < made.people.size(); ++i) {
        EXPECT_LT((made.people[i].position - one.people[i].position).norm(), 1e-12);
        EXPECT_DOUBLE_EQ(made.people[i].radius, one.people[i].radius);
        EXPECT_DOUBLE_EQ(made.people[i].speed_max, one.people[i].speed_max);
      }
    }
  }
}

// A few agents of the shared files, as numbers: this test needs no data.
TEST(Crowd, DrawsTheStartsOfThePublicCode) {
  struct Agent {
    CrowdBenchmark benchmark;
    std::size_t person;  // of case 0
    Vector2d position;
    double radius;
    double speed;
  };
  const Agent agents[] = {
      {CrowdBenchmark::CrowdNav, 0, {-2.6625559084662678, -2.837985290326649}, 0.3, 1.0},
      {CrowdBenchmark::CrowdNav, 1, {-3.6025107218593897, 0.15897818498977123}, 0.3, 1.0},
      {CrowdBenchmark::DsRnn,
       0,
       {5.663690231161839, 1.1517668951049989},
       0.342466536184544,
       1.3724745351820353},
      {CrowdBenchmark::DsRnn,
       2,
       {5.071944259628953, -3.4221827977002137},
       0.3139164161939909,
       1.24353941459214},
      {CrowdBenchmark::CrowdNavPlus,
       0,
       {5.710926794456521, 8.312335034905532},
       0.35680357356027864,
       0.8585584054282752},
      {CrowdBenchmark::CrowdNavPlus,
       2,
       {-7.305252014254043, -0.6587560329493372},
       0.49517516974036413,
       0.7261498796627934}};
  for (const Agent& agent : agents) {
    const CrowdCase one = draw_case(agent.benchmark, 0, crowd_seed(agent.benchmark, 0));
    ASSERT_GT(one.people.size(), agent.person);
    const CrowdPerson& person = one.people[agent.person];
    EXPECT_LT((person.position - agent.position).norm(), 1e-12);
    EXPECT_LT((person.goal + agent.position).norm(), 1e-12) << "goals are opposite the starts";
    EXPECT_DOUBLE_EQ(person.radius, agent.radius);
    EXPECT_DOUBLE_EQ(person.speed_max, agent.speed);
  }
}

struct TraceState {
  Vector2d position;
  Vector2d velocity;
};
using Trace = std::map<int, std::vector<std::map<int, TraceState>>>;  // [case][step][agent]

Trace read_trace(const std::string& name, double step) {
  Trace trace;
  auto table =
      io::CsvTable::read(shared() + "/" + name, {"case", "time", "agent", "x", "y", "vx", "vy"});
  if (!table) return trace;
  for (std::size_t row = 0; row < table->size(); ++row) {
    auto& steps = trace[table->whole(row, 0, 0, 1000)];
    const double time = table->number(row, 1, 0.0, 1e3);
    steps.resize(static_cast<std::size_t>(std::lround(time / step)) + 1);
    steps.back()[table->whole(row, 2, 0, 100)] = {
        {table->number(row, 3, -50, 50), table->number(row, 4, -50, 50)},
        {table->number(row, 5, -5, 5), table->number(row, 6, -5, 5)}};
  }
  return trace;
}

// Lets people decide in each state of the trace, and returns the largest difference of a velocity.
double largest_difference(CrowdBenchmark benchmark, const std::string& name) {
  const CrowdRules rules = crowd_rules(benchmark);
  double most = 0.0;
  for (const auto& [number, steps] : read_trace(name, rules.step)) {
    const CrowdCase one = draw_case(benchmark, number, crowd_seed(benchmark, number));
    Crowd crowd(benchmark, one);
    for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
      for (std::size_t i = 0; i < crowd.people().size(); ++i) {
        const TraceState& now = steps[k].at(static_cast<int>(i) + 1);
        crowd.place(i, now.position, now.velocity);
      }
      const auto robot = steps[k + 1].find(0);
      crowd.move(crowd.choose(),
                 robot == steps[k + 1].end() ? one.start.position : robot->second.position,
                 one.goal);
      for (std::size_t i = 0; i < crowd.people().size(); ++i) {
        const TraceState& next = steps[k + 1].at(static_cast<int>(i) + 1);
        most = std::max(most, (crowd.people()[i].velocity - next.velocity).norm());
      }
    }
  }
  return most;
}

// The benchmarks compute in single precision; the bounds are those of ../shared/data/social.
TEST(Crowd, WalksAsTheSharedTracesDo) {
  if (!has_shared()) GTEST_SKIP() << "no shared data";
  EXPECT_LT(largest_difference(CrowdBenchmark::CrowdNav, "crowdnav_trace.csv"), 1e-5);
  EXPECT_LT(largest_difference(CrowdBenchmark::DsRnn, "dsrnn_trace.csv"), 3e-5);
  EXPECT_LT(largest_difference(CrowdBenchmark::CrowdNavPlus, "crowdnavpp_trace.csv"), 6.1e-4);
}

TEST(Crowd, KeepsPeopleApartAndUnderTheirSpeed) {
  for (const CrowdBenchmark benchmark : {CrowdBenchmark::CrowdNav, CrowdBenchmark::DsRnn}) {
    const CrowdCase one = draw_case(benchmark, 7, crowd_seed(benchmark, 7));
    Crowd crowd(benchmark, one);
    for (int k = 0; k < 100; ++k) {
      crowd.move(crowd.choose(), one.start.position, one.goal);
      for (std::size_t i = 0; i < crowd.people().size(); ++i) {
        const CrowdPerson& person = crowd.people()[i];
        EXPECT_LE(person.velocity.norm(), person.speed_max + 1e-9);
        for (std::size_t j = 0; j < i; ++j) {
          const CrowdPerson& other = crowd.people()[j];
          EXPECT_GT((person.position - other.position).norm(), person.radius + other.radius - 0.05);
        }
      }
    }
  }
}

TEST(Crowd, LooksAheadWithoutMoving) {
  const CrowdCase one = draw_case(CrowdBenchmark::CrowdNav, 3, 1003);
  Crowd crowd(CrowdBenchmark::CrowdNav, one);
  const auto ahead = crowd.look_ahead(2);
  EXPECT_EQ(crowd.people()[0].position, one.people[0].position);
  crowd.move(crowd.choose(), one.start.position, one.goal);
  EXPECT_EQ(crowd.people()[0].position, ahead[0][0]);
  crowd.move(crowd.choose(), one.start.position, one.goal);
  EXPECT_EQ(crowd.people()[4].position, ahead[1][4]);
}

}  // namespace
}  // namespace fairway
