// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "fairway/map/bit_grid.hpp"
#include "fairway/map/body_clearance.hpp"
#include "fairway/map/distance_field.hpp"
#include "fairway/simulation/bodies/body_robot.hpp"
#include "fairway/simulation/judges/zone_judge.hpp"
#include "fairway/simulation/people/moving_body.hpp"
#include "fairway/simulation/physics.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/unicycle_robot.hpp"

namespace fairway {

/// What a robot touched, for messages to users.
struct Contact {
  enum class With : std::uint8_t { Nothing, StaticObstacle, Body, Robot };

  With with = With::Nothing;
  std::size_t other = 0;  ///< index of the body or robot
  /// Speed of the other towards the robot at the contact; not above 0 if it moved away [m/s].
  double other_approach = 0.0;
};

/// What the simulator observed of one robot, at its own fine steps.
struct Encounter {
  /// Of a robot that has touched nothing and has not been measured yet.
  [[nodiscard]] static Encounter unharmed() noexcept;

  bool collided = false;
  bool absent = false;          ///< the robot was removed from the running world
  double collision_time = 0.0;  ///< of the first contact [s]
  Contact contact{};
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

  /// Sends a command to a robot with a model, which executes it instead of its entry of `commands`.
  /// @pre the robot has a model.
  void send(std::size_t robot, const BaseInput& input);

  /// A robot with a model; null for one without.
  [[nodiscard]] const BodyRobot* model_of(std::size_t robot) const;

  /// Distance from the body of a robot to static obstacles, at most kClearanceLimit [m].
  [[nodiscard]] double clearance(std::size_t robot) const;

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
  bool try_place(std::size_t robot, const Pose2& pose);

  /// Replaces the motion of a body; index `num_bodies()` adds a body. @pre it has a key frame.
  void set_body(std::size_t index, const MovingBody& body);

  /// Removes a body; the indices after it decrease by one. @pre it exists.
  void remove_body(std::size_t index);

  /// Places a robot at standstill, and forgets its contact. @pre it exists.
  void place_robot(std::size_t index, const Pose2& pose);

  /// Adds a robot at standstill. @pre there is no physics engine.
  void add_robot(const RobotTask& task, const Settings& settings);

  /// Removes a robot from the world but keeps its index, or puts it back where it was. An absent
  /// robot does not move, and touches nothing. @pre it exists.
  void set_present(std::size_t index, bool present);

  /// Applies the body of the robots, and the limits of those whose base the scenario does not
  /// describe.
  void set_robots(const Settings& settings);

  /// Replaces the zones that the robots are judged by.
  void set_zones(const Zones& zones) { zones_ = zones; }

  [[nodiscard]] const Footprint& footprint() const noexcept { return footprint_; }

  /// All present bodies with their current motion.
  void moving_bodies(std::vector<MovingObstacle>& seen) const;

  /// The moving obstacles that robot `robot` sees: all bodies and all other robots.
  void moving_around(std::size_t robot, std::vector<MovingObstacle>& seen) const;

 private:
  void move(const std::vector<Twist2>& commands, double dt);
  void let_people_walk(double dt);
  void judge(std::size_t robot);
  void judge_all_zones();
  void measure_clearance(std::size_t robot);
  [[nodiscard]] double body_distance(std::size_t robot, const Eigen::Vector2d& point) const;
  template <typename Visit>
  void visit_discs(std::size_t robot, const Visit& visit) const;
  void append(const RobotTask& task);
  struct Gap {
    double length;             // infinite without moving obstacles [m]
    Eigen::Vector2d position;  // centre of the nearest body or robot
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
    Contact::With with = Contact::With::Nothing;
    std::size_t other = 0;
  };
  [[nodiscard]] bool is_further(std::size_t robot, std::size_t other, double length) const;
  [[nodiscard]] Gap gap_to_moving(std::size_t robot) const;

  BitGrid obstacles_;
  Footprint footprint_;
  BodyShape shape_;  // the same
  std::vector<UnicycleRobot> robots_;
  std::vector<std::optional<UnicycleLimits>> actuation_;  // of each, where the scenario says so
  std::vector<std::optional<BodyRobot>> models_;          // of each, where the scenario says so
  std::optional<DistanceField> distances_;                // only with such robots
  std::vector<std::optional<BodyClearance>> clearances_;
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
