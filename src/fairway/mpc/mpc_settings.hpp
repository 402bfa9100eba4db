// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/base/setting.hpp"
#include "fairway/mpc/control_problem.hpp"

namespace fairway {

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(Integration /*type*/) noexcept {
  return {"euler", "midpoint"};
}

/// The part of the optimal control problem that does not change from cycle to cycle.
struct MpcSettings {
  int horizon = 20;
  double dt = 0.1;
  Integration integration = Integration::Midpoint;
  double linear_min = 0.0;
  double linear_max = 1.0;
  double angular_max = 1.5;
  double linear_acceleration_max = 2.0;
  double angular_acceleration_max = 4.0;
  double weight_position = 20.0;  ///< on the squared distance to the step's target
  double weight_heading = 0.5;
  double weight_next_position = 5.0;  ///< Q2, second of the paper's two targets
  double weight_next_heading = 0.05;
  double weight_linear = 0.1;
  double weight_angular = 0.1;
  double weight_linear_change = 0.1;
  double weight_angular_change = 0.1;
  bool penalise_first_change = true;
  double decay_rate = 5.0;  ///< gamma, Eq. (14)
  double violation_weight = 1e4;
  int max_iterations = 100;
};

/// The paper's Table I, where it gives a value: Euler steps, never slower than 0.05 m/s, no limit
/// on acceleration (1000 never binds), no price on the first change. Table I omits S: we take 0.1.
[[nodiscard]] inline MpcSettings paper_mpc_settings() noexcept {
  return {.horizon = 10,
          .dt = 0.1,
          .integration = Integration::Euler,
          .linear_min = 0.05,
          .linear_max = 1.0,
          .angular_max = 1.5,
          .linear_acceleration_max = 1000.0,
          .angular_acceleration_max = 1000.0,
          .weight_position = 20.0,
          .weight_heading = 0.1,
          .weight_next_position = 5.0,
          .weight_next_heading = 0.05,
          .weight_linear = 0.1,
          .weight_angular = 0.1,
          .weight_linear_change = 0.1,
          .weight_angular_change = 0.1,
          .penalise_first_change = false,
          .decay_rate = 5.0,
          .violation_weight = 1e4,
          .max_iterations = 100};
}

template <typename Settings, typename Visitor>
void visit_mpc(Settings& s, Visitor&& field) {
  field(s.horizon,
        SettingInfo{"horizon", "steps", "how many steps ahead are planned", 1, kMaxHorizon});
  field(s.dt, SettingInfo{"dt", "s", "length of a step; also the control period", 0.01, 1});
  field(s.integration, SettingInfo{"integration", "", "euler (the paper's) or midpoint"});
  field(s.linear_min,
        SettingInfo{"linear_min", "m/s", "least linear speed; negative allows reversing", -10, 10});
  field(s.linear_max, SettingInfo{"linear_max", "m/s", "greatest linear speed", 0.01, 10});
  field(s.angular_max, SettingInfo{"angular_max", "rad/s", "greatest angular speed", 0.01, 20});
  field(s.linear_acceleration_max,
        SettingInfo{"linear_acceleration_max", "m/s^2",
                    "greatest change of linear speed per second", 0.01, 1000});
  field(s.angular_acceleration_max,
        SettingInfo{"angular_acceleration_max", "rad/s^2",
                    "greatest change of angular speed per second", 0.01, 1000});
  field(s.weight_position,
        SettingInfo{"weight_position", "1/m^2", "pull to the target position (Q1)", 0, 1e6});
  field(s.weight_heading,
        SettingInfo{"weight_heading", "1/rad^2", "pull to the target heading (Q1)", 0, 1e6});
  field(s.weight_next_position, SettingInfo{"weight_next_position", "1/m^2",
                                            "pull to the second target position (Q2)", 0, 1e6});
  field(s.weight_next_heading, SettingInfo{"weight_next_heading", "1/rad^2",
                                           "pull to the second target heading (Q2)", 0, 1e6});
  field(s.weight_linear,
        SettingInfo{"weight_linear", "s^2/m^2", "price of linear speed (R)", 0, 1e6});
  field(s.weight_angular,
        SettingInfo{"weight_angular", "s^2/rad^2", "price of angular speed (R)", 0, 1e6});
  field(s.weight_linear_change, SettingInfo{"weight_linear_change", "s^2/m^2",
                                            "price of a change of linear speed (S)", 0, 1e6});
  field(s.weight_angular_change, SettingInfo{"weight_angular_change", "s^2/rad^2",
                                             "price of a change of angular speed (S)", 0, 1e6});
  field(s.penalise_first_change, SettingInfo{"penalise_first_change", "",
                                             "price the jump from the command being executed too"});
  field(s.decay_rate,
        SettingInfo{"decay_rate", "1/s", "how fast a barrier may shrink (gamma); at most 1/dt",
                    0.01, 100});
  field(s.violation_weight,
        SettingInfo{"violation_weight", "1/m",
                    "price of leaving the corridor or entering a keep-out disc", 1, 1e8});
  field(s.max_iterations,
        SettingInfo{"max_iterations", "", "iteration budget of one solve", 1, 10000});
}

}  // namespace fairway
