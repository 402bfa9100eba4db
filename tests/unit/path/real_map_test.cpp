// SPDX-License-Identifier: Apache-2.0
// On maps of real buildings; generated_map_test.cpp has the same on maps that are always there.
#include <cctype>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "fairway/io/maps/map_file.hpp"
#include "fairway/path/path_planner.hpp"
#include "support/worlds/path_check.hpp"
#include "support/worlds/path_survey.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

std::optional<BitGrid> shared_map(const std::string& name) {
  std::string file = FAIRWAY_SHARED_DATA;
  file.append("/maps/").append(name).append(".yaml");
  const auto map = io::read_map(file);
  if (!map) return std::nullopt;
  return BitGrid(*map);
}

class RealMaps : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    obstacles = shared_map(GetParam());
    if (!obstacles) GTEST_SKIP() << "no map " << GetParam() << " in " << FAIRWAY_SHARED_DATA;
  }

  std::optional<BitGrid> obstacles;
};

TEST_P(RealMaps, PathsKeepTheirClearanceAndExistWhereCellsConnect) {
  test::expect_paths_where_cells_connect(*obstacles);
}

INSTANTIATE_TEST_SUITE_P(Shared,
                         RealMaps,
                         testing::Values("depot", "tb3_world", "willow-full-0.05"),
                         [](const auto& map) {
                           std::string name = map.param;
                           std::erase_if(name, [](char c) { return std::isalnum(c) == 0; });
                           return name;
                         });

// A start and goal in Willow Garage. "Grown by 0.3 m" counts from cell centre to cell centre; this
// leaves the cells free that are at least 0.2755 m from every occupied square.
TEST(Willow, TheLongestPairIsShorterThanAnEightConnectedPath) {
  const auto obstacles = shared_map("willow-full-0.05");
  if (!obstacles) GTEST_SKIP() << "no willow-full-0.05 in " << FAIRWAY_SHARED_DATA;
  const DistanceField distances(*obstacles);
  PathPlanner planner;
  PathSettings settings;
  const Vector2d start(36.27, 24.23);
  const Vector2d goal(6.73, 2.33);
  const double radius = 0.2755 - settings.margin;
  const auto length = [&] {
    const PathResult result = planner.find(*obstacles, distances, start, goal, radius, settings);
    test::expect_sound(*obstacles, result, start, goal, radius, settings.margin);
    return result.path.length();
  };
  const double careful = length();
  settings.any_angle = false;
  settings.comfort_weight = 0.0;
  const double eight_connected = length();
  settings.any_angle = true;
  const double shortest = length();
  EXPECT_LT(shortest, 0.97 * eight_connected);
  EXPECT_LT(careful, 1.02 * eight_connected);
}

}  // namespace
}  // namespace fairway
