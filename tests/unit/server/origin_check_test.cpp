// SPDX-License-Identifier: Apache-2.0
#include "server/network/origin_check.hpp"

#include <gtest/gtest.h>

namespace fairway::app {
namespace {

TEST(OriginCheck, AllowsTheNamesOfThisMachineOnly) {
  const OriginCheck check;
  for (const char* host : {"localhost", "localhost:8787", "127.0.0.1", "127.0.0.1:1", "[::1]:80"})
    EXPECT_TRUE(check.allows_host(host)) << host;
  for (const char* host : {"", "example.com", "localhost.example.com", "127.0.0.1.example.com",
                           "192.168.0.7:80", "[::2]", ":80", "localhost:80:80"})
    EXPECT_FALSE(check.allows_host(host)) << host;
}

TEST(OriginCheck, AllowsConfiguredAddressesAndNames) {
  const OriginCheck check{.hosts = {"robot.local"}, .origins = {}, .any_address = true};
  EXPECT_TRUE(check.allows_host("192.168.0.7:8787"));
  EXPECT_TRUE(check.allows_host("[fe80::1]:8787"));
  EXPECT_TRUE(check.allows_host("robot.local:8787"));
  EXPECT_FALSE(check.allows_host("example.com"));
}

TEST(OriginCheck, AllowsItsOwnPagesProgramsAndConfiguredSites) {
  const OriginCheck check{
      .hosts = {}, .origins = {"https://app.foxglove.dev"}, .any_address = false};
  const char* host = "127.0.0.1:8787";
  EXPECT_TRUE(check.allows_origin("", host));
  EXPECT_TRUE(check.allows_origin("http://127.0.0.1:8787", host));
  EXPECT_TRUE(check.allows_origin("https://app.foxglove.dev", host));
  for (const char* origin : {"null", "http://127.0.0.1", "http://127.0.0.1:8788",
                             "https://127.0.0.1:8787", "https://example.com", "http://"})
    EXPECT_FALSE(check.allows_origin(origin, host)) << origin;
}

}  // namespace
}  // namespace fairway::app
