// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/number_text.hpp"

#include <gtest/gtest.h>

namespace fairway::io {
namespace {

TEST(NumberText, ReadsWhatPeopleWrite) {
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(parse_number("+2"), 2.0);
  EXPECT_EQ(parse_number("-1e-3"), -0.001);
  EXPECT_EQ(parse_integer("-7"), -7);
}

TEST(NumberText, RefusesTextThatIsNoFiniteNumber) {
  for (const char* text : {"", " 1", "1 ", "nan", "inf", "-inf", ".nan", "1e400", "0x10", "1,5",
                           "1_000", "+-1", "--1", "1.2.3", "e5"}) {
    EXPECT_FALSE(parse_number(text)) << text;
  }
  for (const char* text : {"", "1.0", "99999999999", "1e3", "one"}) {
    EXPECT_FALSE(parse_integer(text)) << text;
  }
}

TEST(NumberText, ReadsBackToTheSameBits) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, -12345678.9, 5e-324}) {
    EXPECT_EQ(parse_number(number_text(value)), value);
  }
}

TEST(NumberText, QuotesOnOneShortLine) {
  EXPECT_EQ(excerpt("a\nb\x01"), "'a?b?'");
  EXPECT_EQ(excerpt(std::string(100, 'x')), "'" + std::string(40, 'x') + "...'");
}

}  // namespace
}  // namespace fairway::io
