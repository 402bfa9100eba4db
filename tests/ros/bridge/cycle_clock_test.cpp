// SPDX-License-Identifier: Apache-2.0
#include "bridge/cycle_clock.hpp"

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

TEST(CycleClock, KeepsThePeriodWithoutScans) {
  CycleClock clock(false);
  clock.begin(10.0);
  EXPECT_FALSE(clock.due(10.09, 0.1, false));
  EXPECT_TRUE(clock.due(10.1001, 0.1, false));
}

TEST(CycleClock, SynchronisesWithAFasterLidar) {
  CycleClock clock(true);
  const double period = 0.1;
  double last = 0.033;  // out of phase with the scans at 0.05 k
  clock.begin(last);
  double wait = 1.0;  // from the last scan before a cycle to the cycle
  for (int ms = 34; ms < 3000; ++ms) {
    const double now = 0.001 * ms;
    if (!clock.due(now, period, ms % 50 == 0)) continue;
    EXPECT_GE(now - last, 0.9 * period - 1e-9);
    EXPECT_LE(now - last, 1.1 * period + 0.0011);
    wait = 0.001 * (ms % 50);
    last = now;
    clock.begin(now);
  }
  EXPECT_EQ(wait, 0.0);
}

TEST(CycleClock, ContinuesWithoutScansAndAfterTheClockWasSetBack) {
  CycleClock clock(true);
  clock.begin(10.0);
  EXPECT_FALSE(clock.due(10.105, 0.1, false));
  EXPECT_TRUE(clock.due(10.1101, 0.1, false));
  EXPECT_TRUE(clock.due(3.0, 0.1, false));
}

}  // namespace
}  // namespace fairway::bridge
