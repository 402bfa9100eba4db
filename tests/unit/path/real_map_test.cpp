// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gtest/gtest.h>

#include "fairway/path/path_planner.hpp"
#include "support/path_check.hpp"
#include "support/path_oracle.hpp"
#include "support/pgm_map.hpp"
#include "support/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

struct RealMap {
  const char* name;
  double free_threshold;
};

class RealMaps : public testing::TestWithParam<RealMap> {
 protected:
  void SetUp() override {
    const std::string file = std::string(FAIRWAY_SHARED_DATA) + "/maps/" + GetParam().name + ".pgm";
    obstacles = test::read_pgm_map(file, 0.05, GetParam().free_threshold);
    if (!obstacles) GTEST_SKIP() << "no " << file;
  }

  std::optional<BitGrid> obstacles;
};

TEST_P(RealMaps, PathsKeepTheirClearanceAndExistWhereCellsConnect) {
  const DistanceField distances(*obstacles);
  const GridFrame& frame = obstacles->frame();
  test::Random random(51);
  PathPlanner planner;
  const PathSettings settings;
  const double radius = 0.25;
  int found = 0;
  int asked = 0;
  while (asked < 40) {
    const auto point = [&] {
      return frame.to_world({random.uniform(0, frame.width), random.uniform(0, frame.height)});
    };
    const Vector2d start = point();
    const Vector2d goal = point();
    const double required = radius + settings.margin;
    const Vector2d a = frame.center(frame.cell_at(start));
    const Vector2d b = frame.center(frame.cell_at(goal));
    if (!is_free(*obstacles, start, a, required) || !is_free(*obstacles, goal, b, required))
      continue;
    ++asked;
    const PathResult result = planner.find(*obstacles, distances, start, goal, radius, settings);
    if (result.status == PathStatus::Found) {
      ++found;
      test::expect_sound(*obstacles, result, start, goal, radius, settings.margin);
    } else if (asked <= 10) {
      EXPECT_FALSE(
          test::is_connected(*obstacles, required, frame.cell_at(start), frame.cell_at(goal)));
    }
  }
  EXPECT_GT(found, 5);
}

INSTANTIATE_TEST_SUITE_P(Shared,
                         RealMaps,
                         testing::Values(RealMap{"depot", 0.25},
                                         RealMap{"tb3_world", 0.196},
                                         RealMap{"willow-full-0.05", 0.196}),
                         [](const auto& map) {
                           std::string name = map.param.name;
                           std::erase_if(name, [](char c) { return !std::isalnum(c); });
                           return name;
                         });

// The pair of FIELD_NOTES section 2. "Grown by 0.3 m" there counts from cell centre to cell centre;
// that leaves free the cells at least 0.2755 m from every occupied square.
TEST(Willow, TheLongestPairIsShorterThanAnEightConnectedWay) {
  const auto obstacles =
      test::read_pgm_map(std::string(FAIRWAY_SHARED_DATA) + "/maps/willow-full-0.05.pgm", 0.05);
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
