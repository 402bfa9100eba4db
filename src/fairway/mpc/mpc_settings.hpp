// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/base/setting.hpp"
#include "fairway/mpc/control_problem.hpp"

namespace fairway {

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(Integration /*type*/) noexcept {
  return {"euler", "midpoint"};
}

/// Settings of the optimal control problem: horizon, model and weights. Limits of speed and
/// acceleration belong to the robot.
struct MpcSettings {
  int horizon = 20;          ///< number of steps planned ahead, 1 to 50
  double step_length = 0.1;  ///< time between the steps of the horizon [s], 0.01 to 1
  Integration integration = Integration::Midpoint;  ///< method of integrating the model over a step
  double weight_position = 20.0;  ///< of the distance to the target (Q1) [1/m^2], 0 to 1e6
  double weight_heading = 0.5;    ///< of the deviation from its heading (Q1) [1/rad^2], 0 to 1e6
  double weight_next_position = 5.0;   ///< of the distance to the second target (Q2) [1/m^2]
  double weight_next_heading = 0.05;   ///< of the deviation from its heading (Q2) [1/rad^2]
  double weight_linear = 0.1;          ///< of linear speed (R) [s^2/m^2], 0 to 1e6
  double weight_angular = 0.1;         ///< of angular speed (R) [s^2/rad^2], 0 to 1e6
  double weight_linear_change = 0.1;   ///< of a change of linear speed (S) [s^2/m^2], 0 to 1e6
  double weight_angular_change = 0.1;  ///< of a change of angular speed (S) [s^2/rad^2], 0 to 1e6
  bool penalise_first_change = true;   ///< also weigh the change from the last command
  double decay_rate = 5.0;        ///< rate at which a barrier may shrink (gamma) [1/s], Eq. (14)
  double violation_weight = 1e4;  ///< penalty weight of soft constraints [1/m], 1 to 1e8
  int max_iterations = 100;       ///< iteration budget of one solve, 1 to 10000
};

template <typename Settings, typename Visitor>
void visit_mpc(Settings& s, Visitor&& field) {
  field(s.horizon,
        SettingInfo{"horizon", "steps",
                    "number of steps planned ahead; more steps look further ahead and take longer",
                    1, kMaxHorizon});
  field(s.step_length, SettingInfo{"step_length", "s",
                                   "time between the steps of the horizon; a greater value looks "
                                   "further ahead and models motion less exactly",
                                   0.01, 1});
  field(s.integration, SettingInfo{"integration", "",
                                   "integration of the model over a step: euler (as in the paper) "
                                   "or midpoint (more exact)"});
  field(s.weight_position, SettingInfo{"weight_position", "1/m^2",
                                       "weight of the distance to the target (Q1); a greater value "
                                       "follows the reference path more closely",
                                       0, 1e6});
  field(s.weight_heading,
        SettingInfo{"weight_heading", "1/rad^2",
                    "weight of the deviation from the target heading (Q1); a greater value aligns "
                    "the robot with the reference path sooner",
                    0, 1e6});
  field(s.weight_next_position, SettingInfo{"weight_next_position", "1/m^2",
                                            "weight of the distance to the second target (Q2); a "
                                            "greater value draws the robot towards it earlier",
                                            0, 1e6});
  field(s.weight_next_heading,
        SettingInfo{"weight_next_heading", "1/rad^2",
                    "weight of the deviation from the second target heading (Q2)", 0, 1e6});
  field(s.weight_linear,
        SettingInfo{"weight_linear", "s^2/m^2",
                    "weight of linear speed (R); a greater value drives more slowly", 0, 1e6});
  field(s.weight_angular,
        SettingInfo{"weight_angular", "s^2/rad^2",
                    "weight of angular speed (R); a greater value turns more gently", 0, 1e6});
  field(
      s.weight_linear_change,
      SettingInfo{"weight_linear_change", "s^2/m^2",
                  "weight of a change of linear speed (S); a greater value accelerates more gently",
                  0, 1e6});
  field(s.weight_angular_change,
        SettingInfo{"weight_angular_change", "s^2/rad^2",
                    "weight of a change of angular speed (S); a greater value steers more smoothly",
                    0, 1e6});
  field(s.penalise_first_change,
        SettingInfo{"penalise_first_change", "",
                    "whether the change from the command being executed is weighted too"});
  field(s.decay_rate,
        SettingInfo{"decay_rate", "1/s",
                    "greatest rate at which a barrier may decrease (gamma), at most 1/step_length; "
                    "a greater value approaches moving obstacles faster",
                    0.01, 100});
  field(s.violation_weight,
        SettingInfo{"violation_weight", "1/m",
                    "penalty weight of leaving the corridor or entering a keep-out disc; too small "
                    "a value trades violations for progress",
                    1, 1e8});
  field(
      s.max_iterations,
      SettingInfo{
          "max_iterations", "",
          "iteration budget of one solve; a greater value converges more often and may take longer",
          1, 10000});
}

}  // namespace fairway
