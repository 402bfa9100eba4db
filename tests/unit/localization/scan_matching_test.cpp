// SPDX-License-Identifier: Apache-2.0
#include "fairway/localization/scan_matching.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "fairway/geometry/pose2.hpp"
#include "support/oracles/central_difference.hpp"
#include "support/random/random_world.hpp"

namespace fairway {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(ScanMatching, TheJacobianIsExact) {
  test::Random random(1);
  for (int n = 0; n < 100; ++n) {
    const auto any = [&] { return random.uniform(-3.0, 3.0); };
    const Vector2d point(any(), any());
    const Vector2d center(any(), any());
    const SurfacePoint line{.position = {any(), any()}, .normal = direction(any())};
    const Vector3d motion(any(), any(), any());
    const auto residual = [&](const Vector3d& at) {
      const MotionAbout move(center, at);
      EXPECT_LT((move(point) - moved(point, center, at)).norm(), 1e-12);
      return line_residual(move(point), move.turned(point - center), line);
    };
    const auto value = [&](const Eigen::VectorXd& x) {
      return Eigen::VectorXd::Constant(1, residual(Vector3d(x)).value);
    };
    const Eigen::MatrixXd expected = test::central_difference(value, motion);
    EXPECT_LT((residual(motion).jacobian - expected).norm(), 1e-7);
  }
}

// Ends of 360 beams in a room of 6 m x 4 m with a pillar, from `sensor`, with errors of `sigma`
// [m].
std::vector<Vector2d> room(const Pose2& sensor, test::Random& random, double sigma) {
  std::vector<Vector2d> ends;
  for (int i = 0; i < 360; ++i) {
    const Vector2d along = direction(sensor.heading + 0.0175 * i);
    double range = 100.0;
    const auto wall = [&](double from, double to, double step) {
      if (step != 0.0 && (to - from) / step > 0.0) range = std::min(range, (to - from) / step);
    };
    wall(sensor.position.x(), 6.0, along.x());
    wall(sensor.position.x(), 0.0, along.x());
    wall(sensor.position.y(), 4.0, along.y());
    wall(sensor.position.y(), 0.0, along.y());
    const Vector2d away = Vector2d(4.0, 1.5) - sensor.position;
    const double ahead = away.dot(along);
    const double inside = 0.09 - (away - ahead * along).squaredNorm();
    if (ahead > 0.0 && inside > 0.0) range = std::min(range, ahead - std::sqrt(inside));
    range += sigma * (random.uniform(-1.0, 1.0) + random.uniform(-1.0, 1.0));
    ends.emplace_back(sensor.position + range * along);
  }
  return ends;
}

struct Scan {
  std::vector<SurfacePoint> points;
  std::vector<std::size_t> beams;
};

Scan surface(const std::vector<Vector2d>& ends, const Vector2d& sensor) {
  Scan scan;
  surface_of_scan(ends, sensor, scan.points, scan.beams);
  return scan;
}

TEST(ScanMatching, FindsTheMotionBetweenTwoScans) {
  test::Random random(2);
  for (int n = 0; n < 30; ++n) {
    const Pose2 first{.position = {2.0, 2.0}, .heading = 0.0};
    SurfacePoints map(20.0);
    for (const SurfacePoint& point : surface(room(first, random, 0.01), first.position).points)
      map.add(point);
    // The robot is at `truth`, and odometry says `guess`.
    const Pose2 truth{.position = {2.3, 2.1}, .heading = 0.3};
    const Vector3d error(random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06),
                         random.uniform(-0.03, 0.03));
    std::vector<Vector2d> ends = room(truth, random, 0.01);
    for (Vector2d& end : ends)
      end = moved(end, truth.position, error);
    const Vector2d center = truth.position + error.head<2>();
    const ScanMatch match =
        match_scan(map, surface(ends, center).points, center, 1.0 * Matrix3d::Identity());
    EXPECT_LT((match.motion.head<2>() + error.head<2>()).norm(), 0.008);
    EXPECT_NEAR(match.motion.z(), -error.z(), 0.005);
    EXPECT_GT(match.matched, 0.8 * match.used);
  }
}

TEST(ScanMatching, IgnoresAThirdOfTheBeamsThatHitSomethingElse) {
  test::Random random(3);
  const Pose2 first{.position = {2.0, 2.0}, .heading = 0.0};
  SurfacePoints map(20.0);
  for (const SurfacePoint& point : surface(room(first, random, 0.005), first.position).points)
    map.add(point);
  std::vector<Vector2d> ends = room(first, random, 0.005);
  for (std::size_t i = 0; i < 120; ++i)  // a board in front of the wall
    ends[i + 40] = first.position + 0.93 * (ends[i + 40] - first.position);
  const Scan scan = surface(ends, first.position);
  const ScanMatch match = match_scan(map, scan.points, first.position, Matrix3d::Identity());
  EXPECT_LT(match.motion.head<2>().norm(), 0.01);
}

TEST(ScanMatching, WithoutAMapThePriorDecides) {
  const SurfacePoints nothing(20.0);
  test::Random random(4);
  const Pose2 here{.position = {2.0, 2.0}, .heading = 0.0};
  const Scan scan = surface(room(here, random, 0.01), here.position);
  const ScanMatch match = match_scan(nothing, scan.points, here.position, Matrix3d::Identity());
  EXPECT_EQ(match.motion, Vector3d(Vector3d::Zero()));
  EXPECT_EQ(match.matched, 0);
}

TEST(SurfacePoints, NormalsPointToTheSensorAcrossTheWall) {
  test::Random random(5);
  const Pose2 here{.position = {2.0, 2.0}, .heading = 0.0};
  const Scan scan = surface(room(here, random, 0.0), here.position);
  ASSERT_GT(scan.points.size(), 200U);
  int across = 0;
  for (const SurfacePoint& point : scan.points) {
    EXPECT_GT(point.normal.dot(here.position - point.position), 0.0);
    if (point.position.x() < 0.01 && point.normal.x() > 0.99) ++across;
  }
  EXPECT_GT(across, 20);
}

TEST(SurfacePoints, CellsThatLeaveTheWindowAreReused) {
  SurfacePoints points(10.0);
  const SurfacePoint here{.position = {0.1, 0.1}, .normal = {1.0, 0.0}};
  points.add(here);
  EXPECT_NE(points.nearest(here, 0.1), nullptr);
  for (double x = 0.0; x < 60.0; x += 0.1)
    points.add({.position = {x + 1.0, 0.1}, .normal = {1.0, 0.0}});
  EXPECT_EQ(points.nearest(here, 0.1), nullptr);
}

TEST(SurfacePoints, TheNearestPointIsThatOfAScanOverAllPoints) {
  test::Random random(4);
  const auto draw = [&] {
    return SurfacePoint{.position = {random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)},
                        .normal = direction(random.uniform(-3.1, 3.1))};
  };
  SurfacePoints points(10.0);
  std::vector<SurfacePoint> all;
  for (int n = 0; n < 1500; ++n) {
    const SurfacePoint point = draw();
    const std::size_t before = points.added();
    points.add(point);
    if (points.added() > before) all.push_back(point);
  }
  int found = 0;
  for (int n = 0; n < 2000; ++n) {
    const SurfacePoint query = draw();
    const double reach = random.uniform(0.02, SurfacePoints::kCell);
    const SurfacePoint* expected = nullptr;
    double least = reach * reach;
    for (const SurfacePoint& point : all) {
      const double away = (point.position - query.position).squaredNorm();
      if (away >= least || point.normal.dot(query.normal) < 0.5) continue;
      least = away;
      expected = &point;
    }
    const SurfacePoint* const nearest = points.nearest(query, reach);
    ASSERT_EQ(nearest == nullptr, expected == nullptr) << n;
    if (nearest == nullptr) continue;
    ++found;
    EXPECT_EQ(nearest->position, expected->position) << n;
  }
  EXPECT_GT(found, 400);
}

TEST(SurfacePoints, ADiagonalWallOfAMapHasOneNormal) {
  BitGrid map({.width = 60, .height = 60, .resolution = 0.05, .origin = {}}, false);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < y; ++x)
      map.set({x, y}, true);
  }
  SurfacePoints points(10.0);
  add_surface_of_map(map, points);
  const SurfacePoint query{.position = {1.5, 1.5}, .normal = direction(-0.785)};
  const SurfacePoint* const found = points.nearest(query, 0.1);
  ASSERT_NE(found, nullptr);
  EXPECT_GT(found->normal.dot(query.normal), 0.97);
}

}  // namespace
}  // namespace fairway
