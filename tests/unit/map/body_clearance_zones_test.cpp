// SPDX-License-Identifier: Apache-2.0
// Keep-outs around a body, against points of their edges.
#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "fairway/map/body_clearance.hpp"
#include "fairway/zones/zone_map.hpp"
#include "random_body.hpp"
#include "support/oracles/zone_oracle.hpp"

namespace fairway {
namespace {

using Eigen::Vector2d;

constexpr double kEdgeSpacing = 0.012;  // between the points of an edge that are looked at [m]

// A body near a keep-out on an empty map.
struct KeepOutScene {
  explicit KeepOutScene(test::Random& random)
      : polygon(test::random_polygon(random, {5.0, 5.0}, 1.0)),
        bits(OccupancyGrid({.width = 200, .height = 200, .resolution = 0.05, .origin = {}})) {
    bits.set_zones(std::make_shared<const ZoneMap>(Zones{{.polygon = polygon}}, 0.3));
    distances.update(bits);
    body = test::random_body(random, random.uniform(0.2, 0.8));
    pose = {.position = {random.uniform(3.5, 6.5), random.uniform(3.5, 6.5)},
            .heading = random.uniform(-3, 3)};
  }

  [[nodiscard]] BodyClearance clearance() const { return {bits, distances, body}; }

  // The least distance over points of the polygon and of the body; 0 where they overlap.
  [[nodiscard]] double slow_distance() const {
    constexpr int kPerEdge = 200;
    double least = std::numeric_limits<double>::infinity();
    for (const ConvexPart& part : body.parts()) {
      for (std::size_t e = 0; e < polygon.size(); ++e) {
        for (int k = 0; k < kPerEdge; ++k) {
          const Vector2d& a = polygon[e];
          const Vector2d point = a + (polygon[(e + 1) % polygon.size()] - a) * k / kPerEdge;
          least = std::min(least, test::distance_to_part(part, inverse_transform(pose, point)));
        }
      }
      if (test::winds_around(polygon, transform(pose, part.vertex(0)))) least = 0.0;
    }
    return least;
  }

  test::Corners polygon;
  BitGrid bits;
  DistanceField distances;
  BodyShape body;
  Pose2 pose;
};

TEST(BodyClearance, ObeysKeepOutsExactly) {
  int blocked = 0;
  int free = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    const KeepOutScene scene(random);
    const double wanted = random.uniform(0.0, 0.3);
    const bool is_free = scene.clearance().is_free(scene.pose, wanted);
    (is_free ? free : blocked) += 1;
    if (is_free) {
      EXPECT_GT(scene.slow_distance(), wanted);
    } else {
      EXPECT_LT(scene.slow_distance(), wanted + kEdgeSpacing);
    }
  }
  EXPECT_GT(free, 50);
  EXPECT_GT(blocked, 50);
}

TEST(BodyClearance, ContactsWithKeepOutsAreAsNearAsTheirEdges) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    const KeepOutScene scene(random);
    const double least = scene.slow_distance();
    constexpr double kReach = 1.0;  // [m]
    if (least <= 0.0 || least > 0.9 * kReach) continue;
    std::array<BodyContact, BodyClearance::kMaxContacts> found;
    const std::size_t count = scene.clearance().contacts(scene.pose, kReach, found);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < count; ++c)
      nearest = std::min(nearest, found[c].distance);
    EXPECT_LE(nearest, least + 5e-3);  // places further out come first
    EXPECT_GT(nearest, least - kEdgeSpacing);
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

}  // namespace
}  // namespace fairway
