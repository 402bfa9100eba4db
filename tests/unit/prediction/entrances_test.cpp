// SPDX-License-Identifier: Apache-2.0
#include "fairway/prediction/entrances.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(EntranceMap, ExpectsPeopleWhereTheyAppeared) {
  EntranceMap map({-5, -5}, {5, 5});
  map.observe(100.0);
  for (int i = 0; i < 7; ++i)
    map.note({2.0, 1.0});
  EXPECT_NEAR(map.rate(2.0, 1.1), 0.07, 1e-12);
  EXPECT_GT(map.rate(2.0, 1.8), 0.0);
  EXPECT_LT(map.rate(2.0, 1.8), 0.07);
  EXPECT_EQ(map.rate(2.0, 3.0), 0.0);
  map.observe(100.0);
  EXPECT_NEAR(map.rate(2.0, 1.1), 0.035, 1e-12);
}

TEST(EntranceMap, DoesNotTrustAShortObservation) {
  EntranceMap map({-5, -5}, {5, 5});
  map.note({0, 0});
  EXPECT_LT(map.rate(0, 0), 0.05);
}

TEST(EntranceMap, IgnoresWhatIsOutside) {
  EntranceMap map({0, 0}, {2, 2});
  map.note({1e9, 0});
  map.note({std::numeric_limits<double>::quiet_NaN(), 0});
  map.note({-0.2, 1.0});  // just outside, and near to what is inside
  EXPECT_GT(map.rate(0.1, 1.0), 0.0);
  EXPECT_EQ(map.rate(-0.1, 1.0), 0.0);
  EXPECT_EQ(map.rate(1e9, 0.0), 0.0);
  EXPECT_EQ(map.rate(std::numeric_limits<double>::quiet_NaN(), 0.0), 0.0);
}

}  // namespace
}  // namespace fairway
