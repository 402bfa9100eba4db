// SPDX-License-Identifier: Apache-2.0
// Whole runs on maps of real buildings, between seeded random points that are connected;
// generated_maps_test.cpp has the same on maps that are always there.
#include <filesystem>

#include <gtest/gtest.h>

#include "fairway/io/maps/map_file.hpp"
#include "support/worlds/map_crossing.hpp"

namespace fairway {
namespace {

class RealMaps : public testing::TestWithParam<const char*> {};

TEST_P(RealMaps, AreCrossedWithoutContact) {
  const std::filesystem::path maps = std::filesystem::path(FAIRWAY_SHARED_DATA) / "maps";
  const std::string file = (maps / GetParam()).string() + ".yaml";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no shared data: " << file;
  const Expected<OccupancyGrid> map = io::read_map(file);
  ASSERT_TRUE(map) << map.error().message;

  test::expect_crossings_without_contact(*map);
}

INSTANTIATE_TEST_SUITE_P(Shared,
                         RealMaps,
                         testing::Values("depot", "tb3_world", "willow-full-0.05"),
                         [](const auto& map) {
                           std::string name = map.param;
                           std::erase_if(name, [](char c) { return std::isalnum(c) == 0; });
                           return name;
                         });

}  // namespace
}  // namespace fairway
