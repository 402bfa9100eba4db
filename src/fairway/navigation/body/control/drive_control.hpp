// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/interior_point/body/body_solver.hpp"
#include "fairway/navigation/body/control/drive_problem.hpp"
#include "fairway/trajectory/tracking_law.hpp"

namespace fairway {

/// What the model predictive control of a drive answers.
struct DriveChoice {
  /// Whether the input below leads to less cost than the follower's.
  bool better = false;
  BaseInput input;             ///< to be sent now, before limits within a period
  double cost = 0.0;           ///< of the motion that begins with it, penalties included
  double follower_cost = 0.0;  ///< of the follower's motion
  double separation = 0.0;     ///< least distance to moving obstacles on it [m]
};

/// Model predictive control of a robot along a drive, for one base.
///
/// In the rectangles along the drive it minimises the deviation from the drive at its own pace. It
/// keeps dynamic barriers to moving obstacles, so it also passes beside them. Each cycle starts
/// from the shifted solution of the cycle before, and from a motion of the follower, to the left or
/// to the right. The result is compared with the follower's motion in the same problem.
template <typename Motion>
class DriveControl {
 public:
  DriveControl(const BaseModel& base,
               const BodyShape& body,
               const MpcSettings& mpc,
               double period,
               double margin) noexcept;

  /// Forgets the solution of the cycle before.
  void forget() noexcept {
    warm_ = false;
    cycle_ = 0;
  }

  [[nodiscard]] DriveChoice choose(const DriveView& view) noexcept;

 private:
  void simulate_follower(const DriveView& view) noexcept;
  void shift() noexcept;
  void start_from(const BodyGuess<Motion>& guess, bool trusted) noexcept;
  [[nodiscard]] BodyGuess<Motion> beside_follower(double side) const noexcept;
  void note_phases(const DriveView& view) noexcept;
  [[nodiscard]] double separation(const DriveView& view) const noexcept;
  [[nodiscard]] double cost_of(const BodySolution<Motion>& motion) const noexcept {
    return motion.cost + problem_.violation_weight * motion.sum_violation;
  }

  BaseModel base_;
  double period_;
  double margin_;  // to the sides of rectangles [m]
  TrackingGains gains_{};
  BodyProblem<Motion> problem_;
  BodySolver<Motion> solver_;
  BodySolution<Motion> follower_;  // its motion
  HorizonPhases follower_phases_{};
  BodySolution<Motion> best_;
  HorizonPhases phases_{};  // of the best motion
  BodyGuess<Motion> shifted_;
  bool warm_ = false;
  int cycle_ = 0;  // which start is tried
};

}  // namespace fairway
