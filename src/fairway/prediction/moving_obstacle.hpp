// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include <Eigen/Core>

#include "fairway/base/setting.hpp"
#include "fairway/geometry/pose2.hpp"

namespace fairway {

/// Positions at even intervals, straight between them; before the first it stands at the first,
/// after the last at the last.
struct SampledMotion {
  static constexpr int kMaxSamples = 51;
  double start = 0.0;     ///< time of the first [s]
  double interval = 0.1;  ///< between two [s]
  int count = 0;          ///< at least 1 to be asked
  std::array<Eigen::Vector2d, kMaxSamples> positions;

  [[nodiscard]] Eigen::Vector2d at(double time) const noexcept {
    const double steps = (time - start) / interval;
    if (!(steps > 0.0) || count <= 1) return positions[0];
    const auto last = static_cast<std::size_t>(count - 1);
    if (steps >= count - 1) return positions[last];
    const auto k = static_cast<std::size_t>(steps);
    const double share = steps - static_cast<double>(k);
    return positions[k] + share * (positions[k + 1] - positions[k]);
  }

  /// Adds a sample; beyond the most that fit they are dropped.
  void add(const Eigen::Vector2d& position) noexcept {
    if (count < kMaxSamples) positions[static_cast<std::size_t>(count++)] = position;
  }
};

/// A place that several robots want to pass at a time: everybody goes round it with the centre on
/// the left.
struct Roundabout {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0;  ///< [m]; 0: there is none

  [[nodiscard]] bool exists() const noexcept { return radius > 0.0; }
};

/// The next points of a robot's way, straight between them.
struct UpcomingWaypoints {
  static constexpr int kMaxPoints = 6;
  int count = 0;
  std::array<Eigen::Vector2d, kMaxPoints> points;
};

/// What a robot tells the other robots about itself in every cycle.
struct SharedMotion {
  std::uint32_t robot = 0;  ///< who tells; no two of a fleet are alike
  double time = 0.0;        ///< when it was told, on the clock of all [s]
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< then [m]
  double speed = 0.0;         ///< the greatest in the cycle then, without sign [m/s]
  double radius = 0.0;        ///< of the disc that covers it [m]
  double speed_max = 0.0;     ///< [m/s]
  double acceleration = 0.0;  ///< with which it gains and loses speed [m/s^2]
  double turn_max = 0.0;      ///< [rad/s]
  SampledMotion plan{};       ///< what it intends to do
  SampledMotion stop{};     ///< what it has bound itself to until it tells something else: to stand
  UpcomingWaypoints way{};  ///< from its position on, as it would be without other robots
  bool under_way = false;   ///< it has a way, and is not at its goal
  double distance_to_bottleneck =
      std::numeric_limits<double>::infinity();  ///< to where it meets others in a narrow place [m]
  bool can_step_aside = true;                   ///< and wait there until they have passed
  double retreat_length =
      0.0;  ///< to where it could wait when it cannot step aside; infinite: nowhere [m]
  Roundabout roundabout{};  ///< that it goes round
};

/// Whether a message can be true: all of it is finite, and within bounds that no robot exceeds.
[[nodiscard]] bool is_plausible(const SharedMotion& motion) noexcept;

/// What robots tell of places is rounded to this, so that it is short to send and to keep [m].
inline constexpr double kToldQuantum = 1e-3;

/// The same with the places of plan, stop and way rounded to kToldQuantum. (Lengths are not: robots
/// compare theirs with those of others to agree on who goes first.)
///
/// A place is off by at most kToldQuantum / sqrt(2) then, and so is everything straight between two
/// places: `radius` grows by a little more than that. So who keeps clear of what was rounded keeps
/// clear of the robot.
[[nodiscard]] SharedMotion rounded(SharedMotion motion) noexcept;

/// How far a robot can be from the stop that it told, when it was not heard for `unseen` seconds
/// and may have told others since [m].
///
/// It is taken to brake at once in what it told and in what it has told since. With v its speed
/// when it told, v' = min(speed_max, v + a unseen) the fastest that it can be now, it is at most v'
/// unseen further on, needs (v'^2 - v^2) / 2a more to stop, and has turned its braking by at most 2
/// turn_max unseen.
[[nodiscard]] inline double reach_beyond_stop(const SharedMotion& motion, double unseen) noexcept {
  if (!(unseen > 0.0)) return 0.0;
  const double v = motion.speed;
  const double now = std::fmin(std::fmax(v, motion.speed_max), v + motion.acceleration * unseen);
  const double braking = now * now / (2.0 * motion.acceleration);
  const double turned = std::fmin(2.0, 2.0 * motion.turn_max * unseen);
  return now * unseen + braking - v * v / (2.0 * motion.acceleration) + turned * braking;
}

/// A robot of the fleet, as another one knows it.
struct FleetMember {
  const SharedMotion* motion = nullptr;  ///< the last that was heard of it
  double unseen = 0.0;  ///< for how long it may have told others something else since [s]
};

using Fleet = std::span<const FleetMember>;

/// Something that moves, as a disc: a person, a cart, another robot.
struct MovingObstacle {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< centre now, world frame [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s]
  double radius = 0.0;                                 ///< of the body [m]
};

/// Whether an obstacle can be one: nothing that moves is faster or larger.
[[nodiscard]] inline bool is_plausible(const MovingObstacle& obstacle) noexcept {
  constexpr double kFastest = 1000.0;  // [m/s]
  constexpr double kLargest = 1000.0;  // [m]
  return is_plausible(obstacle.position) && std::abs(obstacle.velocity.x()) <= kFastest &&
         std::abs(obstacle.velocity.y()) <= kFastest && obstacle.radius >= 0.0 &&
         obstacle.radius <= kLargest;
}

using MovingObstacles = std::span<const MovingObstacle>;

/// Where a constant velocity leads after `time` [s]: the paper's prediction.
[[nodiscard]] inline Eigen::Vector2d predicted_position(const MovingObstacle& obstacle,
                                                        double time) noexcept {
  return obstacle.position + time * obstacle.velocity;
}

/// How moving obstacles are predicted, and the distance kept from the prediction.
struct PredictionSettings {
  double obstacle_margin = 0.1;      ///< distance kept beyond both radii [m], 0 to 10
  bool predict_motion = true;        ///< obstacles keep their velocity; false: they stand still
  double obstacle_growth = 0.1;      ///< growth of that distance per second ahead [m/s], 0 to 10
  double obstacle_growth_max = 0.2;  ///< greatest growth of that distance [m], 0 to 10
  double comfort_distance = 0.3;     ///< distance that the robot prefers to keep beyond that [m]
  double time_headway = 0.3;  ///< time by which it prefers to stay out of an obstacle's path [s]
  double deviation_growth = 0.12;  ///< growth of the standard deviation of a prediction [m/s]
};

template <typename Settings, typename Visitor>
void visit_prediction(Settings& s, Visitor&& field) {
  field(s.obstacle_margin,
        SettingInfo{"obstacle_margin", "m", "distance kept from moving obstacles beyond both radii",
                    0, 10, kEssential});
  field(s.predict_motion,
        SettingInfo{"predict_motion", "",
                    "predict that moving obstacles keep their velocity; if not, that they stand "
                    "still"});
  field(s.obstacle_growth,
        SettingInfo{"obstacle_growth", "m/s",
                    "growth of that distance per second ahead, since predictions err", 0, 10});
  field(s.obstacle_growth_max,
        SettingInfo{"obstacle_growth_max", "m", "greatest growth of that distance", 0, 10});
  field(s.comfort_distance,
        SettingInfo{"comfort_distance", "m",
                    "distance that the robot prefers to keep from moving obstacles, beyond "
                    "obstacle_margin and its braking distance; a greater value takes longer "
                    "detours",
                    0, 10});
  field(s.time_headway,
        SettingInfo{"time_headway", "s",
                    "time by which the robot prefers to stay out of the path of a moving obstacle; "
                    "a greater value passes behind rather than in front",
                    0, 10});
  field(s.deviation_growth,
        SettingInfo{"deviation_growth", "m/s",
                    "growth of the standard deviation of predictions per second ahead, beyond the "
                    "controller's horizon",
                    0, 10});
}

}  // namespace fairway
