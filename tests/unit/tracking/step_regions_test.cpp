// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/step_regions.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/random/random_path.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr int kRectangles = 6;

OrientedRectangle long_box(double x0, double y0, double x1, double y1) {
  return {.seed = {x0, y0}, .orientation = 0.0, .min = {0, 0}, .max = {x1 - x0, y1 - y0}};
}

// Boxes along x, 3 m long, of which neighbours share 1 m.
CorridorFollower chain(double robot_x) {
  Corridor corridor;
  for (int i = 0; i < kRectangles; ++i)
    corridor.rectangles.push_back(long_box(2.0 * i, 0.0, 2.0 * i + 3.0, 2.0));
  CorridorFollower follower(corridor, {12.5, 1.0}, {});
  EXPECT_TRUE(follower.update({robot_x, 1.0}, 0.0));
  return follower;
}

using Poses = std::array<Pose2, kMaxHorizon + 1>;

// Poses on the middle line, each `stride` [m] after the one before.
Poses along_x(double from, double stride) {
  Poses poses;
  for (int k = 0; k <= kMaxHorizon; ++k)
    poses[static_cast<std::size_t>(k)].position = {from + stride * k, 1.0};
  return poses;
}

bool is_same(const OrientedRectangle& a, const OrientedRectangle& b) {
  return a.seed == b.seed && a.min == b.min && a.max == b.max && a.orientation == b.orientation;
}

// The index of a rectangle in the chain.
int index_of(const CorridorFollower& corridor, const OrientedRectangle& rectangle) {
  for (std::size_t i = 0; i < corridor.size(); ++i) {
    if (is_same(corridor.admissible(i), rectangle)) return static_cast<int>(i);
  }
  return -1;
}

TEST(BindToCurrent, EveryStepHasTheRectangleOfTheRobotOnly) {
  const CorridorFollower corridor = chain(5.5);
  ControlProblem problem;
  problem.horizon = 17;
  bind_to_current(corridor, problem);
  for (std::size_t k = 1; k <= 17; ++k) {
    ASSERT_EQ(problem.regions[k].count, 1);
    EXPECT_EQ(index_of(corridor, problem.regions[k].rectangles[0]), 2);
  }
  EXPECT_EQ(problem.regions[18].count, 0) << "steps beyond the horizon are untouched";
}

TEST(BindAlong, AGuessInsideTheCorridorSatisfiesItsOwnRegions) {
  test::Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const double from = random.uniform(0.0, 6.0);
    const CorridorFollower corridor = chain(from);
    ControlProblem problem;
    problem.horizon = kMaxHorizon;
    const Poses poses = along_x(from, random.uniform(0.0, 0.12));
    bind_along(corridor, poses, problem);
    for (std::size_t k = 1; k <= kMaxHorizon; ++k) {
      for (int i = 0; i < problem.regions[k].count; ++i) {
        EXPECT_TRUE(
            problem.regions[k].rectangles[static_cast<std::size_t>(i)].contains(poses[k].position))
            << "step " << k;
      }
    }
  }
}

// Then the straight motion from one step to the next lies in a rectangle, which is convex.
TEST(BindAlong, ConsecutiveStepsShareARectangle) {
  test::Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const CorridorFollower corridor = chain(random.uniform(0.0, 12.0));
    ControlProblem problem;
    problem.horizon = kMaxHorizon;
    Poses poses;
    for (Pose2& pose : poses)  // any guess, also one that jumps or leaves the corridor
      pose.position = {random.uniform(-1.0, 14.0), random.uniform(-0.5, 2.5)};
    bind_along(corridor, poses, problem);
    int before = static_cast<int>(corridor.current());  // the last rectangle of the step before
    for (std::size_t k = 1; k <= kMaxHorizon; ++k) {
      const StepRegion& region = problem.regions[k];
      ASSERT_GE(region.count, 1);
      ASSERT_LE(region.count, 2);
      EXPECT_EQ(index_of(corridor, region.rectangles[0]), before) << "step " << k;
      if (region.count == 1) continue;
      EXPECT_EQ(index_of(corridor, region.rectangles[1]), before + 1) << "step " << k;
      ++before;
    }
  }
}

TEST(BindAlong, EntersTheNextRectangleAsSoonAsTheGuessIsInIt) {
  const CorridorFollower corridor = chain(0.5);
  ControlProblem problem;
  problem.horizon = 30;
  bind_along(corridor, along_x(0.5, 0.1), problem);
  // The second rectangle begins at x = 2 m, which the guess reaches in 15 steps.
  for (std::size_t k = 1; k < 15; ++k)
    EXPECT_EQ(problem.regions[k].count, 1) << k;
  const auto first_shared =
      std::find_if(problem.regions.begin() + 1, problem.regions.end(),
                   [](const StepRegion& region) { return region.count == 2; });
  EXPECT_NEAR(static_cast<double>(first_shared - problem.regions.begin()), 15.0, 1.0);
}

TEST(BindAlong, StaysInTheLastRectangle) {
  const CorridorFollower corridor = chain(11.5);
  ASSERT_EQ(corridor.current(), 5U);
  ControlProblem problem;
  problem.horizon = 30;
  bind_along(corridor, along_x(11.5, 0.2), problem);
  for (std::size_t k = 1; k <= 30; ++k) {
    EXPECT_EQ(problem.regions[k].count, 1);
    EXPECT_EQ(index_of(corridor, problem.regions[k].rectangles[0]), 5);
  }
}

ReferencePath reference(const Path& path) {
  ReferencePath result;
  for (const Vector2d& point : path.waypoints) {
    if (result.count == ReferencePath::kMaxPoints) break;
    const auto i = static_cast<std::size_t>(result.count++);
    result.points[i] = point;
    result.arc[i] = i == 0 ? 0.0 : result.arc[i - 1] + (point - result.points[i - 1]).norm();
  }
  return result;
}

// Calls `check(path, bands, obstacles)` for the bands along free paths of random worlds.
template <typename Check>
void for_random_bands(double radius, Check&& check) {
  test::Random random(3);
  int worlds = 0;
  while (worlds < 60) {
    const BitGrid obstacles(test::random_world(random, 80));
    const std::optional<Path> path = test::random_path(random, obstacles, radius);
    if (!path || path->waypoints.size() < 2) continue;
    const ReferencePath line = reference(*path);
    check(line, bands_along(line, radius, obstacles), obstacles);
    ++worlds;
  }
}

TEST(BandsAlong, ARobotInsideABandTouchesNothing) {
  constexpr double kRadius = 0.12;
  for_random_bands(kRadius, [](const ReferencePath& line, const PathBands& bands,
                               const BitGrid& obstacles) {
    ASSERT_EQ(bands.size(), std::min(static_cast<std::size_t>(line.count - 1), bands.capacity()));
    for (std::size_t i = 0; i < bands.size(); ++i)
      EXPECT_TRUE(is_free(obstacles, bands[i], kRadius));
  });
}

TEST(BandsAlong, EachContainsItsPieceOfThePathSoThatConsecutiveOnesOverlap) {
  for_random_bands(
      0.12, [](const ReferencePath& line, const PathBands& bands, const BitGrid& /*obstacles*/) {
        for (std::size_t i = 0; i < bands.size(); ++i) {
          EXPECT_TRUE(bands[i].contains(line.points[i], 1e-9));
          EXPECT_TRUE(bands[i].contains(line.points[i + 1], 1e-9));
        }
      });
}

TEST(BandsAlong, NoWiderOneOfTheFourWidthsIsFree) {
  constexpr double kRadius = 0.12;
  int narrow = 0;
  for_random_bands(
      kRadius, [&](const ReferencePath& line, const PathBands& bands, const BitGrid& obstacles) {
        for (std::size_t i = 0; i < bands.size(); ++i) {
          const double width = bands[i].max.y();
          for (const double wider : {0.05, 0.1, 0.25, 0.5}) {
            if (wider < width + 1e-9) continue;
            ++narrow;
            EXPECT_FALSE(is_free(
                obstacles, segment_rectangle(line.points[i], line.points[i + 1]).shrunk(-wider),
                kRadius))
                << width << " could be " << wider;
          }
        }
      });
  EXPECT_GT(narrow, 20) << "the worlds have narrow places";
}

TEST(BandsAlong, AStepIsBoundToTheBandsThatTheGuessIsIn) {
  const BitGrid floor({.width = 200, .height = 200, .resolution = 0.05, .origin = {}}, false);
  const ReferencePath corner = reference({.waypoints = {{2, 2}, {5, 2}, {5, 5}}});
  const PathBands bands = bands_along(corner, 0.3, floor);
  ASSERT_EQ(bands.size(), 2U);
  ControlProblem problem;
  problem.horizon = 40;
  Poses poses;
  for (int k = 0; k <= 40; ++k) {
    poses[static_cast<std::size_t>(k)].position =
        k <= 20 ? Vector2d(2.0 + 0.15 * k, 2.0) : Vector2d(5.0, 2.0 + 0.15 * (k - 20));
  }
  bind_along(bands, poses, problem);
  EXPECT_TRUE(is_same(problem.regions[1].rectangles[0], bands[0]));
  EXPECT_TRUE(is_same(problem.regions[40].rectangles[0], bands[1]));
  int shared = 0;
  for (std::size_t k = 1; k <= 40; ++k)
    shared += problem.regions[k].count - 1;
  EXPECT_EQ(shared, 1) << "one step is in both";
}

}  // namespace
}  // namespace fairway
