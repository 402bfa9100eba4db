// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/base64.hpp"

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway::io {
namespace {

TEST(Base64, GivesTheExamplesOfItsStandard) {
  const std::pair<const char*, const char*> examples[] = {{"", ""},
                                                          {"f", "Zg=="},
                                                          {"fo", "Zm8="},
                                                          {"foo", "Zm9v"},
                                                          {"foob", "Zm9vYg=="},
                                                          {"fooba", "Zm9vYmE="},
                                                          {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : examples) {
    EXPECT_EQ(to_base64(bytes), text);
    EXPECT_EQ(from_base64(text), bytes);
  }
}

TEST(Base64, KeepsAllBytes) {
  test::Random random(1);
  for (int size = 0; size < 100; ++size) {
    std::string bytes;
    for (int i = 0; i < size; ++i)
      bytes.push_back(static_cast<char>(random.integer(0, 255)));
    EXPECT_EQ(from_base64(to_base64(bytes)), bytes);
  }
}

TEST(Base64, RefusesInvalidText) {
  for (const char* text : {"Z", "Zg=", "Zg", "Z===", "====", "Zm9v*mFy", "Zg==Zg==", "Zm 9"})
    EXPECT_FALSE(from_base64(text)) << text;
}

}  // namespace
}  // namespace fairway::io
