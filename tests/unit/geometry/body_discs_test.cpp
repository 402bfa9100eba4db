// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "fairway/geometry/footprint.hpp"

namespace fairway {
namespace {

TEST(BodyDiscs, AreReadAsTheyAreWritten) {
  const auto discs = parse_body_discs("[[0.2, 0, 0.25], [ -0.2,-0.05 , +1e-1 ]]");
  ASSERT_TRUE(discs);
  ASSERT_EQ(discs->count, 2);
  EXPECT_EQ(discs->discs[0].center, Eigen::Vector2d(0.2, 0.0));
  EXPECT_EQ(discs->discs[1].center, Eigen::Vector2d(-0.2, -0.05));
  EXPECT_EQ(discs->discs[1].radius, 0.1);
  EXPECT_EQ(to_text(*discs), "[[0.2, 0, 0.25], [-0.2, -0.05, 0.1]]");
  EXPECT_EQ(to_text(*parse_body_discs(" [] ")), "[]");
}

TEST(BodyDiscs, TextReadsBackAsTheSameNumbers) {
  BodyDiscs discs;
  ASSERT_TRUE(discs.add({1.0 / 3.0, -2.0 / 7.0}, std::sqrt(0.1)));
  EXPECT_TRUE(parse_body_discs(to_text(discs)) == discs);
}

TEST(BodyDiscs, OtherTextGivesNone) {
  for (const char* text :
       {"", "0.2", "[", "]", "[0.2, 0, 0.25]", "[[0.2, 0]]", "[[0.2, 0, 0.25, 1]]",
        "[[0.2, 0, 0.25]", "[[0.2, 0, 0.25]]]", "[[0.2 0 0.25]]", "[[0.2, 0, 0.25],]",
        "[[nan, 0, 0.25]]", "[[0, 0, inf]]", "[[0, 0, 0]]", "[[0, 0, -1]]", "[[0, 0, 11]]",
        "[[21, 0, 1]]", "[[x, 0, 1]]"}) {
    EXPECT_FALSE(parse_body_discs(text)) << text;
  }
}

TEST(BodyDiscs, AreAtMostEight) {
  BodyDiscs discs;
  for (int i = 0; i < Footprint::kMaxDiscs; ++i)
    EXPECT_TRUE(discs.add({0.1 * i, 0.0}, 0.2));
  EXPECT_FALSE(discs.add({0.0, 0.0}, 0.2));
  EXPECT_TRUE(is_valid(discs));
  discs.discs[3].radius = std::nan("");
  EXPECT_FALSE(is_valid(discs));
}

}  // namespace
}  // namespace fairway
