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
