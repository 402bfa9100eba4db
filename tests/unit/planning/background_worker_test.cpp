// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/background_worker.hpp"

#include <atomic>

#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(BackgroundWorker, RunsOneJobAfterAnother) {
  BackgroundWorker worker;
  int sum = 0;
  for (int i = 1; i <= 100; ++i) {
    EXPECT_TRUE(worker.idle());
    worker.start([&sum, i] { sum += i; });
    worker.wait();
    ASSERT_TRUE(worker.finished());
    worker.collect();
  }
  EXPECT_EQ(sum, 5050);
}

TEST(BackgroundWorker, WaitsForItsJobAtItsEnd) {
  std::atomic<bool> done{false};
  {
    BackgroundWorker worker;
    worker.start([&done] {
      for (volatile int i = 0; i < 1000000;)
        i = i + 1;
      done = true;
    });
  }
  EXPECT_TRUE(done);
}

TEST(BackgroundWorker, NeedsNoThreadWithoutAJob) {
  const BackgroundWorker worker;
  EXPECT_TRUE(worker.idle());
  worker.wait();
}

}  // namespace
}  // namespace fairway
