// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/studies/field_study.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "fairway/map/free_space.hpp"
#include "fairway/simulation/scenarios/generated_maps.hpp"

namespace fairway::reproduction {
namespace {

TEST(FieldStudy, EveryPointLiesInAFreeRectangle) {
  const FieldSeries series = make_fields(5);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const BitGrid obstacles(generate_map(MapKind::Field, 5, kFieldObstacles.at(i)));
    const Field& field = series.at(i);
    ASSERT_EQ(field.points.size(), static_cast<std::size_t>(kFieldPoints));
    for (const auto& rectangles : field.rectangles) {
      EXPECT_LE(rectangles.size(), field.points.size());
      for (const OrientedRectangle& rectangle : rectangles)
        EXPECT_TRUE(is_free(obstacles, rectangle, 0.0));
      for (const Eigen::Vector2d& point : field.points) {
        EXPECT_TRUE(std::any_of(rectangles.begin(), rectangles.end(),
                                [&](const auto& r) { return r.contains(point, 1e-9); }));
      }
    }
  }
}

TEST(FieldStudy, TheFirstRectangleGrowsWithTheNumberOfOrientations) {
  // All three start at the same point, where more orientations can only help.
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    for (const Field& field : make_fields(seed)) {
      const double src = field.rectangles.at(0).front().area();
      const double mdsrc = field.rectangles.at(1).front().area();
      EXPECT_GE(mdsrc, src);
    }
  }
}

TEST(FieldStudy, DoesNotDependOnThreads) {
  const auto one = make_field_series(4, {.threads = 1});
  const auto two = make_field_series(4, {.threads = 2});
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t k = 0; k < one[i].size(); ++k) {
      EXPECT_EQ(one[i].at(k).mean_area(RectangleKind::Mdsrc),
                two[i].at(k).mean_area(RectangleKind::Mdsrc));
    }
  }
}

}  // namespace
}  // namespace fairway::reproduction
