// SPDX-License-Identifier: Apache-2.0
#include "fairway/base/fixed_vector.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Values = FixedVector<int, 5>;

// A std::vector that drops what exceeds five values is the oracle.
TEST(FixedVector, HoldsWhatAVectorHolds) {
  test::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    Values values;
    std::vector<int> oracle;
    for (int change = 0; change < 20; ++change) {
      const int kind = random.integer(0, 3);
      if (kind == 0 && !values.full()) {
        values.push_back(change);
        oracle.push_back(change);
      } else if (kind == 1) {
        const std::vector<int> more(static_cast<std::size_t>(random.integer(0, 4)), change);
        values.append(more.begin(), more.end());
        oracle.insert(oracle.end(), more.begin(), more.end());
        if (oracle.size() > Values::capacity()) oracle.resize(Values::capacity());
      } else if (kind == 2) {
        const auto count =
            static_cast<std::size_t>(random.integer(0, static_cast<int>(values.size())));
        values.pop_front(count);
        oracle.erase(oracle.begin(), oracle.begin() + static_cast<std::ptrdiff_t>(count));
      } else {
        const Values copy = values;
        values.clear();
        values.push_back(-1);
        values = copy;
      }
      ASSERT_EQ(std::vector<int>(values.begin(), values.end()), oracle);
      ASSERT_EQ(values.full(), oracle.size() == Values::capacity());
      ASSERT_EQ(values.empty(), oracle.empty());
    }
  }
}

TEST(FixedVector, AssignmentToItselfKeepsTheValues) {
  Values values{3, 1, 4};
  const Values& same = values;
  values = same;
  EXPECT_EQ(std::vector<int>(values.begin(), values.end()), (std::vector<int>{3, 1, 4}));
  EXPECT_EQ(values.front(), 3);
  EXPECT_EQ(values.back(), 4);
}

TEST(FixedVectorDeathTest, MoreValuesThanFitBreakAPrecondition) {
  Values values{1, 2, 3, 4, 5};
  EXPECT_DEATH(values.push_back(6), "precondition");
  EXPECT_DEATH(values.pop_front(6), "precondition");
}

}  // namespace
}  // namespace fairway
