// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/scan_queue.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace fairway::nav2 {
namespace {

TEST(ScanQueue, UsesEveryScanWhenTransformsComeAtATenthOfTheRate) {
  ScanQueue<double> queue;  // of the time of the scan itself
  std::vector<double> used;
  double transforms = 0.0;  // known up to this time
  for (int i = 1; i <= 400; ++i) {
    const double now = 0.025 * i;  // scans at 40 Hz
    queue.add(now, now);
    if (i % 4 == 0) transforms = now;  // transforms at 10 Hz
    queue.drain(now, [&](double scan) {
      if (scan > transforms) return false;
      used.push_back(scan);
      return true;
    });
  }
  EXPECT_EQ(used.size(), 400U);
  EXPECT_TRUE(std::is_sorted(used.begin(), used.end()));
  EXPECT_EQ(queue.dropped(), 0U);
}

TEST(ScanQueue, DropsOldScansAndIsBounded) {
  ScanQueue<int> queue;
  for (int i = 0; i < 100; ++i)
    queue.add(0.01 * i, i);
  EXPECT_EQ(queue.size(), ScanQueue<int>::kMost);
  std::vector<int> used;
  const auto use = [&](int scan) {
    used.push_back(scan);
    return true;
  };
  queue.drain(1.95, use);  // 0.95 s is the oldest that is not too old
  ASSERT_FALSE(used.empty());
  EXPECT_GE(used.front(), 95);
  queue.add(100.0, 7);  // a clock that jumps back must not keep a scan from the future
  queue.drain(5.0, use);
  EXPECT_EQ(queue.size(), 0U);
  EXPECT_EQ(used.back(), 99);
}

TEST(ScanQueue, AScanWithoutTransformsDoesNotBlockForLongerThanItsAge) {
  ScanQueue<int> queue;
  queue.add(0.0, 1);
  queue.add(0.5, 2);
  std::vector<int> used;
  const auto use = [&](int scan) {
    if (scan == 1) return false;
    used.push_back(scan);
    return true;
  };
  queue.drain(0.6, use);
  EXPECT_TRUE(used.empty());
  queue.drain(1.1, use);
  EXPECT_EQ(used, std::vector<int>{2});
}

}  // namespace
}  // namespace fairway::nav2
