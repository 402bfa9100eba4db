// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fairway/geometry/pose2.hpp"
#include "fairway/simulation/people/uniform_random.hpp"

namespace fairway {

/// The benchmarks with simulated people.
enum class CrowdBenchmark : std::uint8_t {
  CrowdNav,      ///< 5 people on a circle of 4 m (Chen et al. 2019)
  DsRnn,         ///< 5 people on a circle of 6 m, unicycle (Liu et al. 2021)
  CrowdNavPlus,  ///< 20 randomised people on a circle of 8.5 m (Liu et al. 2023)
};

/// A person of a crowd: its state and what it can do.
struct CrowdPerson {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< of the step before [m/s]
  Eigen::Vector2d goal = Eigen::Vector2d::Zero();      ///< [m]
  double radius = 0.3;                                 ///< [m]
  double speed_max = 1.0;                              ///< [m/s]
};

/// The start of a case.
struct CrowdCase {
  int number = 0;
  std::uint32_t seed = 0;
  Pose2 start;                                     ///< of the robot
  Eigen::Vector2d goal = Eigen::Vector2d::Zero();  ///< of the robot [m]
  double robot_radius = 0.3;                       ///< [m]
  double robot_speed = 1.0;                        ///< greatest speed of the robot [m/s]
  std::vector<CrowdPerson> people;
};

/// The rules of a benchmark that its people obey. ../shared/data/social/README.md derives them.
struct CrowdRules {
  double step = 0.25;               ///< between two decisions of the people [s]
  double time_limit = 24.0;         ///< a run that is not over at this time failed [s]
  double circle = 4.0;              ///< radius of the circle on which people start [m]
  std::size_t neighbours = 10;      ///< most that a person considers
  double added_radius = 0.01;       ///< to every radius that a person assumes [m]
  double danger_gap = 0.2;          ///< a smaller gap counts as danger [m]
  bool judges_before_move = false;  ///< contact and goal are tested with the state before the move
};

[[nodiscard]] CrowdRules crowd_rules(CrowdBenchmark benchmark) noexcept;

/// The people of a case, who do not see the robot, and the random numbers of their new goals.
class Crowd {
 public:
  /// The starts are those of the case; the random numbers continue after the case's own draws.
  Crowd(CrowdBenchmark benchmark, const CrowdCase& given);

  [[nodiscard]] const std::vector<CrowdPerson>& people() const noexcept { return people_; }

  /// Puts a person elsewhere, for a comparison with a trace.
  void place(std::size_t person,
             const Eigen::Vector2d& position,
             const Eigen::Vector2d& velocity) noexcept {
    people_[person].position = position;
    people_[person].velocity = velocity;
  }

  /// Returns the velocities that all people choose in the present state.
  [[nodiscard]] std::vector<Eigen::Vector2d> choose();

  /// Moves all people by a step, and then changes the goals that the rules say. The robot only
  /// matters for where a new goal or person may be.
  void move(const std::vector<Eigen::Vector2d>& velocities,
            const Eigen::Vector2d& robot,
            const Eigen::Vector2d& robot_goal);

  /// Returns where people would be after 1 to `steps` steps, if no goal changed: [step][person].
  [[nodiscard]] std::vector<std::vector<Eigen::Vector2d>> look_ahead(int steps);

 private:
  // What a person assumes since its first decision (CrowdNav++).
  struct Assumed {
    double range = 10.0;
    std::vector<double> radii;
  };

  [[nodiscard]] Eigen::Vector2d decide(std::size_t person);
  [[nodiscard]] bool is_clear(const Eigen::Vector2d& place,
                              double radius,
                              const Eigen::Vector2d& robot,
                              const Eigen::Vector2d& robot_goal,
                              std::optional<std::size_t> except) const;
  void change_goals(const Eigen::Vector2d& robot, const Eigen::Vector2d& robot_goal);

  CrowdBenchmark benchmark_;
  CrowdRules rules_;
  double robot_radius_;
  std::vector<CrowdPerson> people_;
  std::vector<std::optional<Assumed>> assumed_;  // none before the first decision
  double range_ = 10.0;                          // last drawn [m]
  double time_ = 0.0;
  int steps_ = 0;
  UniformRandom random_;
};

/// Draws the start of a case from its seed, as the benchmark does it.
/// @param random  Continues after the draws, for what is drawn later in the case; may be null.
/// @param range   The range of sight that was drawn last; may be null [m].
[[nodiscard]] CrowdCase draw_case(CrowdBenchmark benchmark,
                                  int number,
                                  std::uint32_t seed,
                                  UniformRandom* random = nullptr,
                                  double* range = nullptr);

/// Returns the seed of a case.
[[nodiscard]] std::uint32_t crowd_seed(CrowdBenchmark benchmark, int number) noexcept;

/// A person of CrowdNav++ with its own speed, radius and range, before its place is drawn.
[[nodiscard]] CrowdPerson draw_character(UniformRandom& random, double& range);

/// Draws a place on the circle where a person of CrowdNav++ may appear.
[[nodiscard]] Eigen::Vector2d draw_appearance(UniformRandom& random, double circle);

/// Draws a place near the circle of `circle`, off it by at most half of `spread` in x and y.
[[nodiscard]] Eigen::Vector2d draw_on_circle(UniformRandom& random, double circle, double spread);

}  // namespace fairway
