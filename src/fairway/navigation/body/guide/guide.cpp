// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/guide/guide.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "fairway/geometry/angle.hpp"
#include "fairway/navigation/body/guide/path_pieces.hpp"
#include "fairway/planning/obstruction_text.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kSpacing = 0.05;  // of the guide's points [m]

struct Line {
  std::vector<Vector2d> points;
  std::vector<double> headings;
};

// Points at even distances along the poses, with the headings between those given.
Line resampled(const std::vector<PathPose>& poses) {
  Line line;
  double rest = 0.0;  // from the last point to the next pose
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const Vector2d way = poses[i + 1].position - poses[i].position;
    const double length = way.norm();
    const double first = poses[i].heading.value_or(0.0);
    const double turn = poses[i].heading && poses[i + 1].heading
                            ? shortest_turn(first, *poses[i + 1].heading)
                            : 0.0;
    for (; rest < length; rest += kSpacing) {
      line.points.emplace_back(poses[i].position + rest / length * way);
      line.headings.push_back(first + rest / length * turn);
    }
    rest -= length;
  }
  const double last = poses.back().heading.value_or(line.headings.back());
  if ((poses.back().position - line.points.back()).norm() < 0.5 * kSpacing &&
      line.points.size() > 1) {
    line.points.back() = poses.back().position;
    line.headings.back() = last;
  } else {
    line.points.push_back(poses.back().position);
    line.headings.push_back(last);
  }
  return line;
}

// The mean over some points to both sides, as many as there are on both; the ends stay.
std::vector<Vector2d> smoothed(const std::vector<Vector2d>& points) {
  constexpr std::size_t kReach = 4;
  std::vector<Vector2d> result = points;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const std::size_t reach = std::min({kReach, i, points.size() - 1 - i});
    Vector2d sum = Vector2d::Zero();
    for (std::size_t k = i - reach; k <= i + reach; ++k)
      sum += points[k];
    result[i] = sum / static_cast<double>(2 * reach + 1);
  }
  return result;
}

// The direction of a line at each of its points, over some distance to both sides.
std::vector<double> directions(const std::vector<Vector2d>& points) {
  constexpr std::size_t kReach = 3;
  std::vector<double> angles;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2d way =
        points[std::min(i + kReach, points.size() - 1)] - points[i > kReach ? i - kReach : 0];
    angles.push_back(std::atan2(way.y(), way.x()));
  }
  return angles;
}

std::vector<PathPose> without_repeats(const std::vector<PathPose>& poses) {
  constexpr double kSame = 1e-3;  // [m]
  std::vector<PathPose> result;
  for (const PathPose& pose : poses) {
    if (!result.empty() && (pose.position - result.back().position).norm() < kSame) {
      if (pose.heading) result.back().heading = pose.heading;
      continue;
    }
    result.push_back(pose);
  }
  return result;
}

std::string fault_of(const PosePath& path) {
  constexpr double kFurthest = 1e6;  // [m]
  if (path.poses.empty()) return "path: expected at least one pose, found none";
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    const PathPose& pose = path.poses[i];
    const std::string place = joined_text({"path: pose ", std::to_string(i), ": expected "});
    if (!pose.position.allFinite() || pose.position.cwiseAbs().maxCoeff() > kFurthest)
      return joined_text({place, "a position within 1000 km, found ", place_text(pose.position)});
    if (pose.heading && !std::isfinite(*pose.heading))
      return joined_text({place, "a finite heading"});
  }
  if (path.max_deviation && !(*path.max_deviation > 0.0))
    return joined_text(
        {"path: max_deviation: expected more than 0 m, found ", length_text(*path.max_deviation)});
  return {};
}

}  // namespace

Expected<Guide> Guide::make(const PosePath& path, const BaseModel& base) {
  if (const std::string fault = fault_of(path); !fault.empty()) return fail(fault);
  std::vector<PathPose> poses = without_repeats(path.poses);
  Guide guide;
  if (poses.size() == 1) {
    guide.band_.points = {poses.front().position};
    guide.band_.arcs = {0.0};
    guide.headings_ = {poses.front().heading.value_or(0.0)};
    guide.stops_ = {0.0};
    guide.gears_ = {0};
    return guide;
  }
  const bool omni = base.kind == BaseKind::Omni;
  const bool follows_headings =
      omni && std::all_of(poses.begin(), poses.end(),
                          [](const PathPose& pose) { return pose.heading.has_value(); });
  const std::optional<double> last = poses.back().heading;
  double arc = 0.0;
  for (const internal::PathPiece& piece : internal::cut_path(std::move(poses), base)) {
    if (piece.gear < 0 && base.linear_min >= 0.0) {
      return fail(joined_text({"path: the base cannot drive backwards, as from ",
                               place_text(piece.poses.front().position),
                               " on: expected headings along the path"}));
    }
    Line line = resampled(piece.poses);
    const std::vector<Vector2d> given = std::exchange(line.points, smoothed(line.points));
    for (std::size_t i = 0; i < given.size(); ++i)
      guide.shift_ = std::max(guide.shift_, (given[i] - line.points[i]).norm());
    if (!follows_headings) {
      line.headings = directions(line.points);
      for (double& heading : line.headings)
        heading += piece.gear < 0 ? std::numbers::pi : 0.0;
    }
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      if (i > 0) arc += (line.points[i] - line.points[i - 1]).norm();
      guide.band_.points.push_back(line.points[i]);
      guide.band_.arcs.push_back(arc);
      guide.headings_.push_back(line.headings[i]);
    }
    guide.stops_.push_back(arc);
    guide.gears_.push_back(piece.gear);
  }
  if (last) guide.headings_.back() = *last;
  for (std::size_t i = 1; i < guide.headings_.size(); ++i)
    guide.headings_[i] =
        guide.headings_[i - 1] + shortest_turn(guide.headings_[i - 1], guide.headings_[i]);
  return guide;
}

std::size_t Guide::segment_at(double arc) const noexcept {
  const auto found = std::upper_bound(stops_.begin(), stops_.end(), arc + 1e-6);
  return std::min(static_cast<std::size_t>(found - stops_.begin()), stops_.size() - 1);
}

Pose2 Guide::at(double arc) const noexcept {
  const auto found = std::lower_bound(band_.arcs.begin(), band_.arcs.end(), arc - 1e-9);
  const auto i = static_cast<std::size_t>(found - band_.arcs.begin());
  if (i >= band_.arcs.size())
    return {.position = band_.points.back(), .heading = wrap_to_pi(headings_.back())};
  if (i == 0) return {.position = band_.points.front(), .heading = wrap_to_pi(headings_.front())};
  const double length = band_.arcs[i] - band_.arcs[i - 1];
  const double share =
      length > 0.0 ? std::clamp((arc - band_.arcs[i - 1]) / length, 0.0, 1.0) : 1.0;
  return {.position = (1.0 - share) * band_.points[i - 1] + share * band_.points[i],
          .heading = wrap_to_pi((1.0 - share) * headings_[i - 1] + share * headings_[i])};
}

int Guide::gear_after(double arc) const noexcept { return gears_[segment_at(arc)]; }

double Guide::next_stop(double arc) const noexcept { return stops_[segment_at(arc)]; }

double Guide::begin(const Vector2d& position) const noexcept {
  constexpr double kHardly = 0.25;  // [m]
  double least = std::numeric_limits<double>::infinity();
  for (const Vector2d& point : band_.points)
    least = std::min(least, (point - position).norm());
  std::size_t i = 0;
  while ((band_.points[i] - position).norm() > least + kHardly)
    ++i;
  while (i + 1 < band_.points.size() &&
         (band_.points[i + 1] - position).norm() <= (band_.points[i] - position).norm())
    ++i;
  return band_.arcs[i];
}

}  // namespace fairway
