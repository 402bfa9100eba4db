// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "experiments/people/crowd.hpp"
#include "experiments/people/people_robot.hpp"
#include "experiments/people/recorded.hpp"

namespace fairway {

/// How a run among people ended.
enum class PeopleOutcome : std::uint8_t { Success, Contact, Timeout };

[[nodiscard]] constexpr const char* to_text(PeopleOutcome outcome) noexcept {
  switch (outcome) {
    case PeopleOutcome::Success:
      return "success";
    case PeopleOutcome::Contact:
      return "contact";
    case PeopleOutcome::Timeout:
      return "timeout";
  }
  return "unknown";
}

/// A run among people, judged by the rules of its benchmark.
struct PeopleRun {
  int number = 0;  ///< of the case
  PeopleOutcome outcome = PeopleOutcome::Timeout;
  double time = 0.0;     ///< until the run ended [s]
  double path = 0.0;     ///< that the robot drove [m]
  double closest = 0.0;  ///< least distance: between centres (recorded) or bodies (others) [m]
  int steps = 0;         ///< of the benchmark
  int danger = 0;        ///< steps in which the robot was too close to a person, by its rules
  /// Whether the true motion touched a person, also between steps.
  bool contact_between_steps = false;
  std::vector<PeopleRow> rows;  ///< one per control cycle
  std::vector<double> cycle_seconds;
};

/// What a run depends on besides its case.
struct PeopleOptions {
  Settings settings;
  Kinematics kinematics = Kinematics::Ours;
  std::function<double()> clock;
  /// Called after every control cycle with its time and what the robot saw; may be empty.
  std::function<void(double time, const PeopleRobot& robot, std::span<const SeenPerson> people)>
      on_cycle{};
};

/// Sets the robot of the recorded tasks: a disc that touches a person at 0.5 m, at 1.75 m/s.
void use_recorded_robot(Settings& settings);

/// Sets the robot of a benchmark with simulated people.
void use_crowd_robot(CrowdBenchmark benchmark, Kinematics kinematics, Settings& settings);

/// Whether the control period divides the step of the people, so that runs can be judged.
[[nodiscard]] Expected<void> check_period(const Settings& settings, double step);

/// Drives a task among recorded people. @pre check_period holds for a step of 0.1 s.
[[nodiscard]] PeopleRun run_recorded(const RecordedCase& task,
                                     const PeopleRecording& recording,
                                     const PeopleOptions& options);

/// Drives a case among simulated people. @pre check_period holds for the benchmark's step.
[[nodiscard]] PeopleRun run_crowd(CrowdBenchmark benchmark,
                                  const CrowdCase& one,
                                  const PeopleOptions& options);

}  // namespace fairway
