// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/body_stop.hpp"

#include <cmath>

#include "fairway/trajectory/tracking_law.hpp"

namespace fairway {

void make_stop(const BaseModel& base,
               const DriveReference& reference,
               const DriveProgress& progress,
               const BaseInput& sent,
               double period,
               BodyStop& stop) noexcept {
  stop.count = 0;
  stop.next = 0;
  DriveProgress now = progress;
  BaseInput before = sent;
  while (stop.count < BodyStop::kMostInputs) {
    now = reference.advanced(now, 0.0, period);
    const BaseInput wanted =
        now.rate == 0.0 ? resting_input(base, before) : reference.input_at(now);
    before = limited_input(base, before, wanted, period);
    stop.inputs[static_cast<std::size_t>(stop.count++)] = before;
    if (is_at_rest(base, before)) return;
  }
  stop.count = 0;
}

namespace {

// That a person stops or turns back cannot be foreseen, so the stop has to fit that, too.
bool hits_moving(const BodyShape& body,
                 const Pose2& pose,
                 const StopSurroundings& surroundings,
                 double time) noexcept {
  const auto hits = [&](double share) {
    return body_separation(body, pose, surroundings.moving, time, share) < 0.0;
  };
  return hits(1.0) || (surroundings.may_turn && (hits(0.0) || hits(-1.0)));
}

}  // namespace

StopVerdict check_stop(const BaseModel& base,
                       const Pose2& pose,
                       const BaseInput& sent,
                       const BaseInput& input,
                       const BodyStop& stop,
                       double period,
                       const StopSurroundings& surroundings) noexcept {
  if (stop.count == 0) return StopVerdict::HitsStatic;
  const BodyClearance& clearance = *surroundings.clearance;
  Pose2 now = pose;
  BaseInput from = sent;
  if (base.response_time > 0.0 && !is_at_rest(base, sent)) {
    const Pose2 next = driven(base, now, sent, sent, base.response_time);
    if (!clearance.is_free(now, twist_between(now, next), 1.0, surroundings.margin))
      return StopVerdict::HitsStatic;
    now = next;
  }
  for (int i = -1; i < stop.count; ++i) {
    const BaseInput& to = i < 0 ? input : stop.inputs[static_cast<std::size_t>(i)];
    if (is_at_rest(base, from) && is_at_rest(base, to)) break;
    const BaseInput middle = 0.5 * (from + to);
    // Two halves: within each the motion is an arc to less than the margin.
    for (const int half : {0, 1}) {
      const Pose2 next =
          driven(base, now, half == 0 ? from : middle, half == 0 ? middle : to, 0.5 * period);
      if (!clearance.is_free(now, twist_between(now, next), 1.0, surroundings.margin))
        return StopVerdict::HitsStatic;
      now = next;
      const double time = base.response_time + period * (i + 1 + 0.5 * (half + 1));
      if (hits_moving(clearance.body(), now, surroundings, time)) return StopVerdict::HitsMoving;
    }
    from = to;
  }
  return StopVerdict::Free;
}

}  // namespace fairway
