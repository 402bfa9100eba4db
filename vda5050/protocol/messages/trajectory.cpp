// SPDX-License-Identifier: Apache-2.0
#include "protocol/messages/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace fairway::vda5050 {

namespace {

constexpr double kFurthestPoint = 1e7;  // [m], as the library accepts
constexpr int kHighestDegree = 20;

std::vector<double> uniform_knots(std::size_t points, std::size_t degree) {
  std::vector<double> knots(points + degree + 1, 0.0);
  const std::size_t spans = points - degree;
  for (std::size_t i = 0; i <= spans; ++i)
    knots[degree + i] = static_cast<double>(i) / static_cast<double>(spans);
  std::fill(knots.end() - static_cast<std::ptrdiff_t>(degree), knots.end(), 1.0);
  return knots;
}

// Explains what is wrong with the knots; empty for sound ones.
std::string knot_fault(const Trajectory& t) {
  constexpr double kEqual = 1e-9;
  const auto degree = static_cast<std::size_t>(t.degree);
  const std::size_t expected = t.points.size() + degree + 1;
  if (t.knots.size() != expected) {
    return "expected " + std::to_string(expected) + " knots (control points + degree + 1), found " +
           std::to_string(t.knots.size());
  }
  for (std::size_t i = 0; i < t.knots.size(); ++i) {
    if (!(t.knots[i] >= 0.0 && t.knots[i] <= 1.0)) return "expected knots from 0 to 1";
    if (i > 0 && t.knots[i] < t.knots[i - 1]) return "expected knots that do not decrease";
  }
  for (std::size_t i = 0; i <= degree; ++i) {
    if (t.knots[i] > kEqual || t.knots[t.knots.size() - 1 - i] < 1.0 - kEqual) {
      return "expected the first and the last knot degree + 1 times (0 and 1)";
    }
  }
  std::size_t equal = 1;
  for (std::size_t i = degree + 2; i + degree + 1 < t.knots.size(); ++i) {
    equal = t.knots[i] - t.knots[i - 1] <= kEqual ? equal + 1 : 1;
    if (equal > degree) return "expected inner knots at most degree times";
  }
  return {};
}

}  // namespace

Eigen::Vector2d Trajectory::at(double parameter) const {
  const auto p = static_cast<std::size_t>(degree);
  const double u = std::clamp(parameter, knots.front(), knots.back());
  // The span [knots[k], knots[k + 1]) that contains u; the last one that is not empty contains 1.
  std::size_t k = p;
  while (k + 1 < points.size() && u >= knots[k + 1])
    ++k;
  std::vector<Eigen::Vector3d> d(p + 1);
  for (std::size_t j = 0; j <= p; ++j) {
    const ControlPoint& point = points[k - p + j];
    d[j] << point.weight * point.position, point.weight;
  }
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t j = p; j >= r; --j) {
      const double low = knots[j + k - p];
      const double width = knots[j + 1 + k - r] - low;
      const double share = width > 0.0 ? (u - low) / width : 0.0;
      d[j] = (1.0 - share) * d[j - 1] + share * d[j];
    }
  }
  return d[p].head<2>() / d[p].z();
}

std::vector<Eigen::Vector2d> Trajectory::polyline(double chord, double sagitta) const {
  std::vector<Eigen::Vector2d> line{at(knots.front())};
  constexpr int kDeepest = 12;
  const auto refine = [&](auto&& self, double from, const Eigen::Vector2d& a, double to,
                          const Eigen::Vector2d& b, int depth) -> void {
    const double middle = 0.5 * (from + to);
    const Eigen::Vector2d m = at(middle);
    const Eigen::Vector2d along = b - a;
    const double length = along.norm();
    const double off = length > 0.0
                           ? std::abs(along.x() * (m - a).y() - along.y() * (m - a).x()) / length
                           : (m - a).norm();
    // A curve can cross its chord in the middle: at least two halvings are made.
    const bool coarse = depth < 2 && degree > 1;
    if (depth < kDeepest && (coarse || off > sagitta || length > chord)) {
      self(self, from, a, middle, m, depth + 1);
      self(self, middle, m, to, b, depth + 1);
      return;
    }
    if (length > 0.0) line.push_back(b);
  };
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (knots[i] > knots[i - 1])
      refine(refine, knots[i - 1], at(knots[i - 1]), knots[i], at(knots[i]), 0);
  }
  return line;
}

Trajectory read_trajectory(FieldReader& reader, bool needs_knots) {
  Trajectory t;
  const FieldRange range{.low = 1, .high = kHighestDegree};
  const double degree = needs_knots ? reader.number("degree", range)
                                    : reader.optional_number("degree", range).value_or(1.0);
  if (std::floor(degree) != degree) reader.complain("degree", "expected a whole number");
  t.degree = std::max(1, static_cast<int>(degree));
  for (FieldReader& point : reader.objects("controlPoints")) {
    const FieldRange place{.low = -kFurthestPoint, .high = kFurthestPoint};
    ControlPoint read;
    read.position = {point.number("x", place), point.number("y", place)};
    read.weight = point.optional_number("weight").value_or(1.0);
    if (!(read.weight > 0.0)) point.complain("weight", "expected a number above 0");
    t.points.push_back(read);
  }
  if (!reader.sound()) return t;
  if (t.points.size() < static_cast<std::size_t>(t.degree) + 1) {
    reader.complain("controlPoints",
                    "expected at least degree + 1 = " + std::to_string(t.degree + 1) +
                        " points, found " + std::to_string(t.points.size()));
    return t;
  }
  if (reader.has("knotVector")) {
    t.knots = reader.numbers("knotVector");
  } else if (needs_knots) {
    reader.complain("knotVector", "expected a list of numbers, found nothing");
  } else {
    t.knots = uniform_knots(t.points.size(), static_cast<std::size_t>(t.degree));
  }
  if (!reader.sound()) return t;
  if (std::string fault = knot_fault(t); !fault.empty())
    reader.complain("knotVector", std::move(fault));
  return t;
}

nlohmann::json to_json(const Trajectory& trajectory) {
  nlohmann::json points = nlohmann::json::array();
  for (const ControlPoint& point : trajectory.points) {
    points.push_back(
        {{"x", point.position.x()}, {"y", point.position.y()}, {"weight", point.weight}});
  }
  return {{"degree", trajectory.degree},
          {"knotVector", trajectory.knots},
          {"controlPoints", std::move(points)}};
}

Trajectory polyline_trajectory(const std::vector<Eigen::Vector2d>& points) {
  Trajectory t;
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
    length += (points[i] - points[i - 1]).norm();
  double arc = 0.0;
  t.knots.push_back(0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) arc += (points[i] - points[i - 1]).norm();
    const double even =
        static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(1, points.size() - 1));
    t.knots.push_back(length > 0.0 ? std::min(1.0, arc / length) : even);
    t.points.push_back({.position = points[i]});
  }
  if (t.points.size() == 1) t.points.push_back(t.points.front());
  if (t.knots.size() == 2) t.knots.push_back(1.0);
  t.knots.back() = 1.0;
  t.knots.push_back(1.0);
  return t;
}

}  // namespace fairway::vda5050
