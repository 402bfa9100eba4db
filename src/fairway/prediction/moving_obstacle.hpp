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

/// Positions at even intervals, with straight lines between them. The motion stays at the first
/// position before the start, and at the last one after the end.
struct SampledMotion {
  static constexpr int kMaxSamples = 51;
  double start = 0.0;     ///< time of the first sample [s]
  double interval = 0.1;  ///< between two samples [s]
  int count = 0;          ///< number of samples; `at` needs at least 1
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

  /// Adds a sample; samples beyond kMaxSamples are dropped.
  void add(const Eigen::Vector2d& position) noexcept {
    if (count < kMaxSamples) positions[static_cast<std::size_t>(count++)] = position;
  }
};

/// A circle around a place where the paths of several robots meet. All of them drive around its
/// centre with the centre on their left.
struct Roundabout {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0;  ///< [m]; 0: there is none

  [[nodiscard]] bool exists() const noexcept { return radius > 0.0; }
};

/// The next points of a robot's path, with straight lines between them.
struct UpcomingWaypoints {
  static constexpr int kMaxPoints = 6;
  int count = 0;
  std::array<Eigen::Vector2d, kMaxPoints> points;
};

/// The outline of a robot that is no disc, for those who receive its motion: a box in its frame,
/// and the headings with which it turns.
struct SharedOutline {
  bool is_box = false;                             ///< otherwise the robot is a disc
  Eigen::Vector2d low = Eigen::Vector2d::Zero();   ///< corner at the back and to the right [m]
  Eigen::Vector2d high = Eigen::Vector2d::Zero();  ///< corner in front and to the left [m]
  std::array<double, SampledMotion::kMaxSamples> plan_headings{};  ///< at the samples of `plan`
  std::array<double, SampledMotion::kMaxSamples> stop_headings{};  ///< at the samples of `stop`
};

/// The message that a robot publishes to the other robots in every control cycle.
struct SharedMotion {
  std::uint32_t robot = 0;  ///< number of the sender, unique in the fleet
  double time = 0.0;        ///< of publication, on the fleet's clock [s]
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< at that time [m]
  double speed = 0.0;                                  ///< greatest of that cycle, unsigned [m/s]
  double radius = 0.0;                                 ///< of the disc that covers the robot [m]
  double speed_max = 0.0;                              ///< [m/s]
  double acceleration = 0.0;  ///< least of acceleration and braking [m/s^2]
  double turn_max = 0.0;      ///< [rad/s]
  SampledMotion plan{};       ///< motion that the robot intends
  SampledMotion stop{};       ///< motion that it has committed to, until its next message
  UpcomingWaypoints way{};    ///< its path, as it would be without other robots
  bool under_way = false;     ///< whether it follows a path and is not at its goal
  double distance_to_bottleneck =
      std::numeric_limits<double>::infinity();  ///< to the narrow place where it meets others [m]
  bool can_step_aside = true;                   ///< whether it can move aside and wait there
  double retreat_length =
      0.0;                  ///< to a place where the others can pass; infinite if there is none [m]
  Roundabout roundabout{};  ///< roundabout that the robot follows
  SharedOutline outline{};  ///< true outline; see BodyNavigator::share
};

/// Returns whether a message is plausible: every number is finite and within bounds that no robot
/// exceeds.
[[nodiscard]] bool is_plausible(const SharedMotion& motion) noexcept;

/// Published positions are rounded to this, which shortens messages and recordings [m].
inline constexpr double kToldQuantum = 1e-3;

/// Returns the message with the positions of plan, stop and path rounded to kToldQuantum. (Lengths
/// are not rounded: robots compare them to agree on who goes first.)
///
/// Rounding moves a position, and every point between two positions, by at most kToldQuantum /
/// sqrt(2). `radius` grows by slightly more, so a robot that keeps clear of the rounded motion
/// keeps clear of the robot.
[[nodiscard]] SharedMotion rounded(SharedMotion motion) noexcept;

/// Returns how far a robot can be from the stop in its newest message [m]. It may have published
/// other messages in the last `unseen` seconds, which were not received.
///
/// The robot is assumed to brake at once in the stop that it published, and in every later one.
/// With v its speed when it published, v' = min(speed_max, v + a unseen) is its greatest speed now.
/// It is then at most v' unseen further on, needs (v'^2 - v^2) / 2a more to stop, and has turned
/// its braking path by at most 2 turn_max unseen.
[[nodiscard]] inline double reach_beyond_stop(const SharedMotion& motion, double unseen) noexcept {
  if (!(unseen > 0.0)) return 0.0;
  const double v = motion.speed;
  const double now = std::fmin(std::fmax(v, motion.speed_max), v + motion.acceleration * unseen);
  const double braking = now * now / (2.0 * motion.acceleration);
  const double turned = std::fmin(2.0, 2.0 * motion.turn_max * unseen);
  return now * unseen + braking - v * v / (2.0 * motion.acceleration) + turned * braking;
}

/// A robot of the fleet, as another robot knows it.
struct FleetMember {
  const SharedMotion* motion = nullptr;  ///< its newest message that was received
  double unseen = 0.0;                   ///< time in which it may have published a newer one [s]
};

using Fleet = std::span<const FleetMember>;

/// A moving obstacle as a disc: a person, a cart, another robot.
struct MovingObstacle {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< centre now, world frame [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s]
  double radius = 0.0;                                 ///< of the body [m]
};

/// Returns whether an obstacle is plausible: finite, and neither faster nor larger than any real
/// one.
[[nodiscard]] inline bool is_plausible(const MovingObstacle& obstacle) noexcept {
  constexpr double kFastest = 1000.0;  // [m/s]
  constexpr double kLargest = 1000.0;  // [m]
  return is_plausible(obstacle.position) && std::abs(obstacle.velocity.x()) <= kFastest &&
         std::abs(obstacle.velocity.y()) <= kFastest && obstacle.radius >= 0.0 &&
         obstacle.radius <= kLargest;
}

using MovingObstacles = std::span<const MovingObstacle>;

/// Returns the position after `time` [s] at constant velocity: the paper's prediction.
[[nodiscard]] inline Eigen::Vector2d predicted_position(const MovingObstacle& obstacle,
                                                        double time) noexcept {
  return obstacle.position + time * obstacle.velocity;
}

/// Settings of the prediction of moving obstacles, and of the distance kept from it.
struct PredictionSettings {
  double obstacle_margin = 0.1;      ///< distance kept beyond both radii [m], 0 to 10
  bool predict_motion = true;        ///< obstacles keep their velocity; false: their position
  double obstacle_growth = 0.1;      ///< growth of that distance per second ahead [m/s], 0 to 10
  double obstacle_growth_max = 0.2;  ///< greatest growth of that distance [m], 0 to 10
  double comfort_distance = 0.3;     ///< distance that the robot prefers to keep beyond that [m]
  double time_headway = 0.3;  ///< time by which it prefers to stay out of an obstacle's path [s]
  double deviation_growth = 0.18;  ///< growth of the standard deviation of a prediction [m/s]
};

template <typename Settings, typename Visitor>
void visit_prediction(Settings& s, Visitor&& field) {
  field(s.obstacle_margin,
        SettingInfo{"obstacle_margin", "m", "distance kept from moving obstacles beyond both radii",
                    0, 10, kEssential});
  field(s.predict_motion,
        SettingInfo{"predict_motion", "",
                    "predict that moving obstacles keep their velocity; if not, that they stop"});
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
