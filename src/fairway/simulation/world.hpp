// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/simulation/moving_body.hpp"
#include "fairway/simulation/physics.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/unicycle_robot.hpp"

namespace fairway {

/// What the simulator has seen happen to one robot, at its own fine steps.
struct Encounter {
  bool collided = false;
  double collision_time = 0.0;  ///< of the first contact [s]
  /// How fast the robot then went by itself towards what moves and was touched, or at all where it
  /// touched what stands [m/s]; not above 0: it was run over while standing or going away.
  double approach = 0.0;
  double min_clearance;   ///< least distance from the body to a static obstacle [m]
  double min_separation;  ///< least distance to another body, infinite without any [m]
};

/// The true world: robots and bodies that move, obstacles that stand. It judges contact, with the
/// robots' true footprints (or the engine's, where one moves them); no controller does.
class World {
 public:
  /// The integration and contact step; a control cycle is cut into whole steps of at most this [s].
  static constexpr double kFineStep = 0.005;
  /// Static clearance is measured up to here [m].
  static constexpr double kClearanceLimit = 2.0;

  /// @param physics  The engine that moves the robots; null for the unicycle.
  explicit World(const Scenario& scenario, std::unique_ptr<Physics> physics = nullptr);

  /// Moves everything for `dt` [s] while each robot executes its command. A robot that has touched
  /// something stays where it is.
  void advance(const std::vector<Twist2>& commands, double dt);

  [[nodiscard]] double time() const noexcept { return time_; }
  [[nodiscard]] const std::vector<UnicycleRobot>& robots() const noexcept { return robots_; }
  [[nodiscard]] const std::vector<Encounter>& encounters() const noexcept { return encounters_; }
  [[nodiscard]] const BitGrid& obstacles() const noexcept { return obstacles_; }

  [[nodiscard]] std::size_t num_bodies() const noexcept { return bodies_.size(); }
  [[nodiscard]] const MovingBody& body(std::size_t index) const { return bodies_.at(index); }

  /// Makes a cell an obstacle, or free. Refuses cells outside the map and, for an obstacle, cells
  /// that touch a robot. @return whether the cell is now as wanted.
  bool set_blocked(CellIndex cell, bool blocked);

  /// Gives a body another way to go; index `num_bodies()` adds it. @pre it has a key frame.
  void set_body(std::size_t index, const MovingBody& body);

  /// Takes a body away; those behind it move up. @pre it exists.
  void remove_body(std::size_t index);

  /// Takes over the body of the robots, and the limits of those whose base the scenario does not
  /// describe.
  void set_robots(const Settings& settings);

  [[nodiscard]] const Footprint& footprint() const noexcept { return footprint_; }

  /// Every body that is there, as it moves now.
  void moving_bodies(std::vector<MovingObstacle>& seen) const;

  /// What robot `robot` sees moving: every body, and every other robot.
  void moving_around(std::size_t robot, std::vector<MovingObstacle>& seen) const;

 private:
  void move(const std::vector<Twist2>& commands, double dt);
  void judge(std::size_t robot);
  struct Gap {
    double length;             // infinite without anything that moves [m]
    Eigen::Vector2d position;  // of the centre of what is behind it
  };
  [[nodiscard]] Gap gap_to_moving(std::size_t robot) const;

  BitGrid obstacles_;
  Footprint footprint_;
  std::vector<UnicycleRobot> robots_;
  std::vector<std::optional<UnicycleLimits>> actuation_;  // of each, where the scenario says so
  std::vector<Encounter> encounters_;
  std::vector<MovingBody> bodies_;
  std::unique_ptr<Physics> physics_;
  std::vector<std::uint8_t> touched_;       // per robot, as the engine says
  std::vector<MovingObstacle> bodies_now_;  // for the engine
  std::vector<Twist2> commands_now_;        // likewise
  double time_ = 0.0;
};

}  // namespace fairway
