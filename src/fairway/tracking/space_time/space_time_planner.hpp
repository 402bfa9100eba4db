// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "fairway/geometry/robot_settings.hpp"
#include "fairway/prediction/entrances.hpp"
#include "fairway/prediction/forecast.hpp"
#include "fairway/tracking/corridor_follower.hpp"
#include "fairway/tracking/space_time/encounter_cost.hpp"
#include "fairway/tracking/space_time/space_time_plan.hpp"
#include "fairway/tracking/space_time/space_time_workspace.hpp"

namespace fairway {

/// What a space-time plan starts from.
struct SpaceTimeInput {
  double time = 0.0;  ///< of the start [s]
  Pose2 pose;         ///< then
  double speed = 0.0;
  const ReferencePath& path;
  const CorridorFollower& corridor;
  MovingObstacles obstacles;
  double age = 0.0;                        ///< from the obstacles' measurement to the start [s]
  const EntranceMap* entrances = nullptr;  ///< where people appear, if that is known
};

/// Plans a motion of several seconds among moving obstacles, in front of the controller. It decides
/// whether and where the robot passes an obstacle on the left or right, in front or behind, or
/// waits.
///
/// The motions form a tree: in every stage of 0.5 s a motion continues with several speeds and
/// turns. Of the motions that end in the same cell of place, heading and speed the cheapest is
/// kept, and then the cheapest kWidth. The cost of a motion is its time, what being near the
/// predicted obstacles costs (EncounterCost), and what the rest costs a point (CostToGo). The work
/// of a plan is bounded by kWidth, the number of stages and that of the obstacles; nothing is
/// allocated.
///
/// The last plan is kept as it is, unless another one costs less by a margin. The robot then does
/// not alternate between two sides of an obstacle, and a new plan does not postpone what the last
/// one began.
class SpaceTimePlanner {
 public:
  /// @param shared  Memory of other planners of this thread, to be shared; null for memory of its
  ///                own. It is only used during `update`.
  SpaceTimePlanner(const RobotSettings& robot,
                   const PredictionSettings& prediction,
                   double horizon,
                   std::shared_ptr<SpaceTimeWorkspace> shared = nullptr);

  /// Plans, or continues the last plan while it is new. @return whether there is a plan; if not,
  /// following the reference path is as good.
  [[nodiscard]] bool update(const SpaceTimeInput& input) noexcept;

  /// Forgets the last plan.
  void reset() noexcept { plan_.stages = 0; }

  [[nodiscard]] const SpaceTimePlan& plan() const noexcept { return plan_; }

 private:
  static constexpr std::size_t kWidth = SpaceTimeWorkspace::kWidth;
  static constexpr std::size_t kLateWidth = 20;  // from stage kLate on
  static constexpr std::size_t kLate = 6;
  static constexpr std::size_t kRectangles = 6;  // ahead, in which a motion may be
  static constexpr double kStage = 0.5;          // [s]

  using Node = SpaceTimeWorkspace::Node;

  struct Rectangle {
    double cosine = 1.0;
    double sine = 0.0;
    Eigen::Vector2d seed;
    Eigen::Vector2d min;
    Eigen::Vector2d max;
  };

  struct Turn {
    double angle = 0.0;  // in a stage [rad]
    double cosine = 1.0;
    double sine = 0.0;
    double quarter_cosine = 1.0;  // of a quarter of it
    double quarter_sine = 0.0;
    double half_cosine = 1.0;
    double half_sine = 0.0;
  };

  [[nodiscard]] static Turn turn_by(double angle) noexcept;
  void prepare(const SpaceTimeInput& input) noexcept;
  [[nodiscard]] double cost_at(const NearObstacles& near,
                               double x,
                               double y,
                               double speed,
                               std::size_t sample) const noexcept;
  [[nodiscard]] NearObstacles near_stage(const Node& from, std::size_t stage) const noexcept;
  [[nodiscard]] bool locate(double x, double y, std::uint8_t& rectangle) const noexcept;
  [[nodiscard]] double time_left(const Node& node, double left) const noexcept;
  [[nodiscard]] double entrance_cost(double x, double y) const noexcept;
  [[nodiscard]] double straight_time(const Eigen::Vector2d& place) const noexcept;
  void find_costs_to_go() noexcept;
  [[nodiscard]] double bearing_of_path(const Node& node) const noexcept;
  [[nodiscard]] bool is_goal(const Node& node) const noexcept;
  [[nodiscard]] static double effort(const SpaceTimePlan::State& from,
                                     const SpaceTimePlan::State& to,
                                     double time) noexcept;
  [[nodiscard]] Node start_node() const noexcept;
  [[nodiscard]] bool move(
      const Node& from, std::size_t stage, double speed, const Turn& turn, Node& to) const noexcept;
  void add_encounters(const NearObstacles& near,
                      const Node& from,
                      std::size_t stage,
                      const Turn& turn,
                      Node& to) const noexcept;
  void grow(std::size_t stage) noexcept;
  [[nodiscard]] std::uint32_t& find(const Node& node, std::uint64_t& key) noexcept;
  void keep(std::uint32_t& entry, std::uint64_t key, const Node& node) noexcept;
  void select(std::size_t stage) noexcept;
  void store(std::size_t leaf, SpaceTimePlan& plan) const noexcept;
  [[nodiscard]] double cost_of_reference() const noexcept;
  [[nodiscard]] bool evaluate(const SpaceTimePlan& plan, double& cost) const noexcept;

  RobotSettings robot_;
  double per_top_;  // 1 / robot_.linear_max [s/m]
  std::size_t stages_;
  double acceleration_;  // [m/s^2]
  double slowness_;      // delay per squared lack of speed [s^3/m^2]
  double turn_max_;      // [rad/s]
  std::vector<Turn> turns_;
  PredictionSettings prediction_;
  EncounterCost::Settings encounter_settings_;
  std::shared_ptr<SpaceTimeWorkspace> workspace_;
  // Parts of the workspace, which hold values of this planner during update only.
  Forecast& forecast_;
  EncounterCost& cost_;
  CostToGo& to_go_;
  std::vector<std::vector<Node>>& layers_;
  std::vector<Node>& children_;
  std::vector<std::uint32_t>& order_;
  std::vector<std::uint32_t>& table_;
  std::vector<std::uint64_t>& keys_;
  const SpaceTimeInput* input_ = nullptr;  // during update
  std::array<Rectangle, kRectangles> rectangles_;
  std::size_t rectangle_count_ = 0;
  std::size_t child_count_ = 0;
  double bound_ = 0.0;      // of the total of children in this stage [s]
  double tree_time_ = 0.0;  // when the last tree was grown [s]
  SpaceTimePlan plan_;
  SpaceTimePlan other_;
};

}  // namespace fairway
