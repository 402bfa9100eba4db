// SPDX-License-Identifier: Apache-2.0
// With what a drive begins that is planned in motion. The cycle of a DriveFollower is in
// drive_follower.cpp.
#include <algorithm>
#include <cstddef>
#include <utility>

#include "fairway/navigation/body/drive/drive_follower.hpp"
#include "fairway/trajectory/stopping_trajectory.hpp"

namespace fairway {

namespace {

// Planned drives keep a reserve for corrections, which the present input may use.
BaseInput within_speeds(const BaseModel& base, BaseInput input) noexcept {
  const bool steered = is_steered(base);
  if (steered) input.turn = std::clamp(input.turn, -base.steering_max, base.steering_max);
  const double load = speed_load(base, twist_of(base, input));
  if (load <= 1.0) return input;
  input.linear /= load;
  input.lateral /= load;
  if (!steered) input.turn /= load;
  return input;
}

}  // namespace

DriveLead DriveFollower::lead(const Pose2& pose, double ahead, double step) const {
  constexpr double kReserve = 0.9;  // of accelerations
  constexpr double kSpeed = 0.98;
  const BaseModel planned = with_reserve(base_, kReserve, kSpeed);
  DriveLead lead;
  lead.ahead = {.start = pose, .inputs = {within_speeds(planned, sent_)}, .steps = {}};
  DriveProgress progress = progress_;
  const double time_ahead = at_rest() ? 0.0 : std::max(ahead, base_.response_time);
  for (double time = 0.0; time < time_ahead - 1e-9; time += step) {
    const BaseInput before = lead.ahead.inputs.back();
    progress = reference_.advanced(progress, 1.0, step);
    // A base that responds late does what it was sent before.
    const bool late = time < base_.response_time - 1e-9;
    lead.ahead.inputs.push_back(
        late ? before : limited_input(planned, before, reference_.input_at(progress), step));
    lead.ahead.steps.push_back(step);
  }
  const BaseInput begin = lead.ahead.inputs.back();
  lead.stop = {.start = knot_poses(base_, lead.ahead).back(), .inputs = {begin}, .steps = {}};
  if (is_at_rest(base_, begin)) return lead;
  constexpr double kKnots = 0.1;  // [s]
  const DriveReference gentle =
      reference_.rows().empty() ? DriveReference()
                                : DriveReference(planned, reference_.rows(), reference_.period());
  BodyStop stop;
  make_stop(planned, gentle, progress, begin, kKnots, stop);
  for (int k = 0; k < stop.count; ++k) {
    lead.stop.inputs.push_back(stop.inputs[static_cast<std::size_t>(k)]);
    lead.stop.steps.push_back(kKnots);
  }
  return lead;
}

void DriveFollower::follow_moving(DriveReference reference, double phase) noexcept {
  reference_ = std::move(reference);
  space_ = {};
  controlled_ = false;
  beside_ = 0.0;
  evasive_ = false;
  progress_ = {.phase = phase, .rate = 1.0};
  settled_ = false;
  settling_cycles_ = 0;
}

}  // namespace fairway
