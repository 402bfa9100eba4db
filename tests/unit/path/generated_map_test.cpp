// SPDX-License-Identifier: Apache-2.0
// As real_map_test.cpp, on generated maps of buildings and clutter.
#include <gtest/gtest.h>

#include "fairway/simulation/scenarios/generated_maps.hpp"
#include "support/worlds/path_survey.hpp"

namespace fairway {
namespace {

class GeneratedMaps : public testing::TestWithParam<MapKind> {};

TEST_P(GeneratedMaps, PathsKeepTheirClearanceAndExistWhereCellsConnect) {
  test::expect_paths_where_cells_connect(BitGrid(generate_map(GetParam(), 3, 30)));
}

INSTANTIATE_TEST_SUITE_P(Kinds,
                         GeneratedMaps,
                         testing::Values(MapKind::UnstructuredSmall,
                                         MapKind::Structured,
                                         MapKind::Field),
                         [](const auto& kind) { return std::string(to_text(kind.param)); });

// From corner to corner, as in Willow Garage.
TEST(GeneratedMap, AnAnyAnglePathIsShorterThanAnEightConnectedOne) {
  double sum_careful = 0.0;
  double sum_eight_connected = 0.0;
  double sum_shortest = 0.0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const BitGrid obstacles(generate_map(MapKind::UnstructuredSmall, seed));
    const DistanceField distances(obstacles);
    const Eigen::Vector2d start(1.5, 1.5);
    const Eigen::Vector2d goal(23.5, 23.5);
    PathPlanner planner;
    PathSettings settings;
    const auto length = [&] {
      const PathResult result = planner.find(obstacles, distances, start, goal, 0.25, settings);
      test::expect_sound(obstacles, result, start, goal, 0.25, settings.margin);
      return result.path.length();
    };
    sum_careful += length();
    settings.any_angle = false;
    settings.comfort_weight = 0.0;
    const double eight_connected = length();
    settings.any_angle = true;
    const double shortest = length();
    EXPECT_LE(shortest, eight_connected + 1e-9) << seed;
    sum_eight_connected += eight_connected;
    sum_shortest += shortest;
  }
  EXPECT_LT(sum_shortest, 0.98 * sum_eight_connected);
  EXPECT_LT(sum_careful, 1.05 * sum_eight_connected);
}

}  // namespace
}  // namespace fairway
