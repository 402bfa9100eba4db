// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/recorded/metrics.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(Metrics, QuantilesAreMembersOfTheSample) {
  std::vector<double> sample;
  for (int i = 200; i >= 1; --i)
    sample.push_back(i);
  const Quantiles q = quantiles(sample);
  EXPECT_EQ(q.median, 100.0);
  EXPECT_EQ(q.p99, 198.0);
  EXPECT_EQ(q.max, 200.0);
  EXPECT_EQ(quantile(std::vector<double>{1.0, 2.0, 4.0, 8.0}, 0.0), 1.0);
  EXPECT_EQ(quantile(std::vector<double>{1.0, 2.0, 4.0, 8.0}, 0.75), 4.0);
  EXPECT_EQ(quantiles({}).max, 0.0);
  EXPECT_EQ(quantiles(std::vector<double>{7.0}).p99, 7.0);
}

TEST(Metrics, SmoothnessAndSwitchesCountOneRobotOnly) {
  Trace trace;
  for (int i = 0; i < 3; ++i) {
    trace.rows.push_back(
        {.time = 0.5 * i, .robot = 0, .command = {1.0 * i, 0.0}, .rectangle = i > 1 ? 1U : 0U});
    trace.rows.push_back({.time = 0.5 * i, .robot = 1, .command = {0.0, 5.0 * i}});
  }
  EXPECT_NEAR(smoothness(trace, 0), 2.0 * 1.0 / 0.5, 1e-12);
  EXPECT_EQ(rectangle_switches(trace, 0), 1);
  EXPECT_EQ(rectangle_switches(trace, 1), 0);
}

}  // namespace
}  // namespace fairway
