// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/trajectory/drive_program.hpp"

namespace fairway::internal {

// Places of the variables in a stage.
inline constexpr int kHeading = 2;
inline constexpr int kInputs = 3;   ///< linear, lateral, turn
inline constexpr int kChanges = 6;  ///< of the same
inline constexpr int kStep = 9;

inline constexpr double kShortestStep = 0.03;  ///< [s]
inline constexpr double kLongestStep = 0.35;   ///< [s]

using Inputs = Eigen::Vector3d;

[[nodiscard]] inline Inputs vector_of(const BaseInput& input) noexcept {
  return {input.linear, input.lateral, input.turn};
}
[[nodiscard]] inline BaseInput input_of(const Inputs& v) noexcept { return {v.x(), v.y(), v.z()}; }

/// Limits of the three inputs and of their slopes.
struct InputLimits {
  Inputs low;
  Inputs high;
  Inputs slope;
  bool lateral;

  explicit InputLimits(const BaseModel& base) noexcept;
};

/// gradient . v <= bound in a stage.
void constrain(Stage& stage, const StageVector& gradient, double bound);

/// low <= expression <= high, for its deviation `gradient` . v from `now`; and not beyond `trust`.
void constrain_between(
    Stage& stage, const StageVector& gradient, double now, double low, double high, double trust);

/// Adds all limits of the base in a stage from the inputs `now` to `next`. These are inputs, their
/// slopes, wheels and time step; for steered bases also angular speed and acceleration, linearised.
void add_limits(Stage& stage,
                const BaseModel& base,
                const Inputs& now,
                const Inputs& next,
                double step,
                const TrustRegion& trust);

}  // namespace fairway::internal
