// SPDX-License-Identifier: Apache-2.0
// Times, curves, zones and fields of single messages.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "protocol/messages/timestamp.hpp"
#include "protocol/messages/trajectory.hpp"
#include "protocol/messages/zone_set.hpp"

namespace fairway::vda5050 {
namespace {

using nlohmann::json;

TEST(Timestamp, IsWrittenInUtcWithThreeDigits) {
  EXPECT_EQ(to_timestamp(0.0), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(to_timestamp(1796025600.25), "2026-11-30T08:00:00.250Z");
  EXPECT_EQ(to_timestamp(1709251199.9996), "2024-03-01T00:00:00.000Z");
}

TEST(Timestamp, IsReadWithAnyNumberOfDigits) {
  EXPECT_DOUBLE_EQ(from_timestamp("2026-11-30T08:00:00Z").value_or(0.0), 1796025600.0);
  EXPECT_DOUBLE_EQ(from_timestamp("2026-11-30T08:00:00.5Z").value_or(0.0), 1796025600.5);
  EXPECT_NEAR(from_timestamp("2026-11-30T08:00:00.123456Z").value_or(0.0), 1796025600.123456, 1e-6);
  EXPECT_DOUBLE_EQ(from_timestamp("2026-11-30T09:30:00.00+01:30").value_or(0.0), 1796025600.0);
}

TEST(Timestamp, RefusesOtherTexts) {
  for (const char* text :
       {"", "now", "2026-11-30", "2026-13-30T08:00:00Z", "2026-11-30T08:00:00",
        "2026-02-30T08:00:00Z", "2026-11-30T25:00:00Z", "2026-11-30T08:00:00.Z"}) {
    EXPECT_FALSE(from_timestamp(text)) << text;
  }
}

Trajectory read(const json& curve, bool needs_knots, std::string* fault = nullptr) {
  std::optional<FieldProblem> problem;
  FieldReader reader(curve, "trajectory", problem);
  const Trajectory trajectory = read_trajectory(reader, needs_knots);
  if (fault != nullptr) *fault = problem ? problem->text() : std::string();
  return trajectory;
}

json quarter_circle() {
  return {{"degree", 2},
          {"knotVector", {0, 0, 0, 1, 1, 1}},
          {"controlPoints",
           {{{"x", 0.0}, {"y", -1.0}},
            {{"x", 1.0}, {"y", -1.0}, {"weight", std::numbers::sqrt2 / 2.0}},
            {{"x", 1.0}, {"y", 0.0}}}}};
}

TEST(Trajectory, MakesAnExactQuarterCircle) {
  const Trajectory circle = read(quarter_circle(), true);
  for (double u = 0.0; u <= 1.0; u += 0.01)
    EXPECT_NEAR(circle.at(u).norm(), 1.0, 1e-12) << u;
  const auto line = circle.polyline(0.25, 0.002);
  EXPECT_EQ(line.front(), Eigen::Vector2d(0.0, -1.0));
  EXPECT_NEAR((line.back() - Eigen::Vector2d(1.0, 0.0)).norm(), 0.0, 1e-12);
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length += (line[i] - line[i - 1]).norm();
    EXPECT_GT((0.5 * (line[i] + line[i - 1])).norm(), 1.0 - 0.002);
  }
  EXPECT_NEAR(length, 0.5 * std::numbers::pi, 5e-3);
}

TEST(Trajectory, OfDegreeOnePassesItsPoints) {
  const json curve{
      {"controlPoints", {{{"x", 0}, {"y", 0}}, {{"x", 2}, {"y", 0}}, {{"x", 2}, {"y", 1}}}}};
  const auto line = read(curve, false).polyline(10.0, 0.001);
  ASSERT_EQ(line.size(), 3U);
  EXPECT_EQ(line[1], Eigen::Vector2d(2.0, 0.0));
}

TEST(Trajectory, HasUniformKnotsInVersion3) {
  json curve = quarter_circle();
  curve.erase("knotVector");
  curve["controlPoints"].push_back({{"x", 1.0}, {"y", 2.0}});
  EXPECT_EQ(read(curve, false).knots, (std::vector<double>{0, 0, 0, 0.5, 1, 1, 1}));
  std::string fault;
  (void)read(curve, true, &fault);
  EXPECT_NE(fault.find("knotVector"), std::string::npos) << fault;
}

TEST(Trajectory, RefusesUnsoundKnots) {
  const std::vector<std::vector<double>> unsound{{0, 0, 1, 1, 1},
                                                 {0, 0, 0.1, 1, 1, 1},
                                                 {0, 0, 0, 1, 1, 2},
                                                 {0, 0, 0, 0.9, 1, 1},
                                                 {0, 0, 0, 1, 0, 1}};
  for (const std::vector<double>& knots : unsound) {
    json curve = quarter_circle();
    curve["knotVector"] = knots;
    std::string fault;
    (void)read(curve, true, &fault);
    EXPECT_NE(fault.find("trajectory.knotVector: expected"), std::string::npos) << json(knots);
  }
}

TEST(Trajectory, OfPointsIsReadBack) {
  const std::vector<Eigen::Vector2d> points{{0, 0}, {1, 0}, {1, 3}};
  std::string fault;
  const Trajectory again = read(to_json(polyline_trajectory(points)), true, &fault);
  EXPECT_EQ(fault, "");
  EXPECT_EQ(again.polyline(10.0, 0.01), points);
}

TEST(ZonePolygons, AreSimpleOrRefused) {
  EXPECT_TRUE(is_simple({{0, 0}, {2, 0}, {2, 1}}));
  EXPECT_TRUE(is_simple({{0, 0}, {0, 2}, {2, 2}, {2, 0}, {1, 1}}));
  EXPECT_FALSE(is_simple({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));
  EXPECT_FALSE(is_simple({{0, 0}, {1, 1}, {2, 2}}));
  EXPECT_FALSE(is_simple({{0, 0}, {1, 1}}));
}

TEST(ZonePolygons, MeasureDistance) {
  const std::vector<Eigen::Vector2d> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_DOUBLE_EQ(distance_to(square, {1, 1}), 0.0);
  EXPECT_DOUBLE_EQ(distance_to(square, {3, 1}), 1.0);
  EXPECT_DOUBLE_EQ(distance_to(square, {5, 6}), 5.0);
  EXPECT_DOUBLE_EQ(signed_area(square), 4.0);
}

}  // namespace
}  // namespace fairway::vda5050
