// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/simulation/judges/zone_judge.hpp"
#include "fairway/simulation/moving_body.hpp"
#include "fairway/simulation/physics.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/unicycle_robot.hpp"

namespace fairway {

/// What the simulator observed of one robot, at its own fine steps.
struct Encounter {
  bool collided = false;
  double collision_time = 0.0;  ///< of the first contact [s]
  /// The robot's own speed towards the moving obstacle at the contact, or its speed at a static
  /// obstacle [m/s]. Not above 0: the robot was hit at standstill or while it moved away.
  double approach = 0.0;
  double min_clearance;   ///< least distance from the body to a static obstacle [m]
  double min_separation;  ///< least distance to another body, infinite without any [m]
  ZoneBreaches zones{};   ///< how far it has broken the zones
};

/// The true world: robots, bodies that move, and static obstacles. It judges contact with the true
/// footprints (or the engine's, if one is used); controllers do not.
class World {
 public:
  /// The integration and contact step; a control cycle is cut into whole steps of at most this [s].
  static constexpr double kFineStep = 0.005;
  /// Static clearance is measured up to here [m].
  static constexpr double kClearanceLimit = 2.0;

  /// @param physics  The engine that moves the robots; null for the unicycle.
  explicit World(const Scenario& scenario, std::unique_ptr<Physics> physics = nullptr);

  /// Moves everything for `dt` [s] while each robot executes its command. A robot that has touched
  /// an obstacle does not move any more.
  void advance(const std::vector<Twist2>& commands, double dt);

  [[nodiscard]] double time() const noexcept { return time_; }
  [[nodiscard]] const std::vector<UnicycleRobot>& robots() const noexcept { return robots_; }
  [[nodiscard]] const std::vector<Encounter>& encounters() const noexcept { return encounters_; }
  [[nodiscard]] const BitGrid& obstacles() const noexcept { return obstacles_; }

  [[nodiscard]] std::size_t num_bodies() const noexcept { return bodies_.size(); }
  [[nodiscard]] const MovingBody& body(std::size_t index) const { return bodies_.at(index); }

  /// Makes a cell an obstacle, or free. Refuses cells outside the map and obstacles that touch a
  /// robot. @return whether the cell now has the requested state.
  bool set_blocked(CellIndex cell, bool blocked);

  /// Puts a robot at a pose, at standstill, as a person would move it by hand. Refuses a pose at
  /// which it touches an obstacle, and every pose in an engine, which has its own.
  /// @return whether the robot is there now.
  bool place_robot(std::size_t robot, const Pose2& pose);

  /// Replaces the motion of a body; index `num_bodies()` adds a body. @pre it has a key frame.
  void set_body(std::size_t index, const MovingBody& body);

  /// Removes a body; the indices after it decrease by one. @pre it exists.
  void remove_body(std::size_t index);

  /// Applies the body of the robots, and the limits of those whose base the scenario does not
  /// describe.
  void set_robots(const Settings& settings);

  [[nodiscard]] const Footprint& footprint() const noexcept { return footprint_; }

  /// All present bodies with their current motion.
  void moving_bodies(std::vector<MovingObstacle>& seen) const;

  /// The moving obstacles that robot `robot` sees: all bodies and all other robots.
  void moving_around(std::size_t robot, std::vector<MovingObstacle>& seen) const;

 private:
  void move(const std::vector<Twist2>& commands, double dt);
  void judge(std::size_t robot);
  void judge_all_zones();
  struct Gap {
    double length;             // infinite without moving obstacles [m]
    Eigen::Vector2d position;  // centre of the nearest body or robot
  };
  [[nodiscard]] Gap gap_to_moving(std::size_t robot) const;

  BitGrid obstacles_;
  Footprint footprint_;
  std::vector<UnicycleRobot> robots_;
  std::vector<std::optional<UnicycleLimits>> actuation_;  // of each, where the scenario says so
  std::vector<Encounter> encounters_;
  Zones zones_;
  std::vector<Pose2> judged_;  // poses at the last step, for the zones
  std::vector<MovingBody> bodies_;
  std::unique_ptr<Physics> physics_;
  std::vector<std::uint8_t> touched_;       // per robot, reported by the engine
  std::vector<MovingObstacle> bodies_now_;  // for the engine
  std::vector<Twist2> commands_now_;        // for the engine
  double time_ = 0.0;
};

}  // namespace fairway
