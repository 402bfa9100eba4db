// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/studies/parallel_runs.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace fairway::reproduction {
namespace {

TEST(ParallelRuns, GiveResultsInOrderWithAnyNumberOfThreads) {
  for (const int threads : {1, 2, 7}) {
    const StudyOptions options{.threads = threads};
    const auto squares = run_all(100, options, "squares", [](std::size_t i) { return i * i; });
    ASSERT_EQ(squares.size(), 100U);
    for (std::size_t i = 0; i < squares.size(); ++i)
      EXPECT_EQ(squares[i], i * i);
  }
}

TEST(ParallelRuns, ReportEveryTaskOnce) {
  int calls = 0;
  std::string last;
  StudyOptions options{.threads = 3};
  options.progress = [&](const std::string& state) {
    ++calls;
    last = state;
  };
  run_all(10, options, "work", [](std::size_t i) { return i; });
  EXPECT_EQ(calls, 10);
  EXPECT_EQ(last, "work: 10 of 10");
}

TEST(ParallelRuns, PassOnAFailure) {
  const StudyOptions options{.threads = 2};
  const auto fails = [](std::size_t i) -> int {
    if (i == 5) throw std::runtime_error("five");
    return 0;
  };
  EXPECT_THROW(run_all(50, options, "work", fails), std::runtime_error);
}

TEST(ParallelRuns, NothingToDoGivesNothing) {
  EXPECT_TRUE(run_all(0, {.threads = 2}, "work", [](std::size_t i) { return i; }).empty());
}

}  // namespace
}  // namespace fairway::reproduction
