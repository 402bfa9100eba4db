// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/map/body_clearance.hpp"
#include "fairway/trajectory/drive_band.hpp"
#include "fairway/trajectory/stage_program.hpp"
#include "fairway/trajectory/trajectory.hpp"

namespace fairway {

/// What a trajectory costs besides its time: how much of the limits it uses, squared, per second.
struct TrajectoryCost {
  double linear_effort = 0.02;  ///< at the greatest acceleration, linear and lateral []
  double turn_effort = 0.02;    ///< at the greatest angular acceleration or steering rate []
  double steering_angle = 0.0;  ///< of steered bases, at 1 rad []
};

}  // namespace fairway

namespace fairway::internal {

/// How far one iteration may go from the trajectory before.
struct TrustRegion {
  double position = 0.15;  ///< of a knot, along each axis [m]
  double heading = 0.12;   ///< of a knot [rad]
  double input = 0.4;      ///< of an input, share of its limit []
  double step = 0.35;      ///< of a time step, share of it []
  double damping = 1e-3;   ///< weight of squared changes: large ones end a search
};

/// A pose within a step, and the obstacles near it.
struct DriveSample {
  std::size_t step = 0;
  double share = 1.0;  ///< of the step
  Pose2 pose;
  std::size_t count = 0;
  std::array<BodyContact, BodyClearance::kMaxContacts> contacts;
};

/// A trajectory with a pose of its own at every knot, which the inputs need not reach exactly. A
/// deviation early in a long drive therefore does not change everything after it.
struct DriveIterate {
  Trajectory trajectory;
  std::vector<Pose2> knots;
};

/// An iterate's poses, the obstacles near them, and what it violates.
struct DriveEvaluation {
  std::vector<Pose2> ends;           ///< where the step from each knot leads
  std::vector<DriveSample> samples;  ///< in order of time; only those near obstacles
  double cost = 0.0;                 ///< time and effort [s]
  double violation = 0.0;            ///< clearance that is missing, summed over contacts [m]
  double gaps = 0.0;    ///< between steps' ends and the next knots, and the goal, summed [m, 2 rad]
  double excess = 0.0;  ///< by how much the greatest limit of a steered base is exceeded []
};

/// What an optimisation is about.
struct DriveProblem {
  const BodyClearance* clearance = nullptr;
  BaseModel base;
  Pose2 goal;
  double margin = 0.02;  ///< clearance to be kept at the samples [m]
  TrajectoryCost cost;
  const DriveBand* band = nullptr;  ///< in which the reference point stays; null for none
  double arc = 0.0;                 ///< of the start on the band [m]
};

/// @param reach  How near an obstacle counts [m].
void evaluate(const DriveProblem& problem,
              const DriveIterate& iterate,
              double reach,
              DriveEvaluation& evaluation);

/// The convex program of one iteration: the iterate's linearised motion, its limits, and the
/// obstacles near it as half-planes. Variables are deviations from the iterate: state (x, y,
/// heading, inputs), control (change of the inputs over the step, time step).
void make_program(const DriveProblem& problem,
                  const DriveIterate& iterate,
                  const DriveEvaluation& evaluation,
                  const TrustRegion& trust,
                  StageProgram& program);

/// The iterate moved along the solution of the program by `share` of it.
[[nodiscard]] DriveIterate moved_along(const BaseModel& base,
                                       const DriveIterate& iterate,
                                       const StageSolution& solution,
                                       double share);

}  // namespace fairway::internal
