// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/body_report.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

namespace {

double speed_of(const BaseInput& input) noexcept { return std::hypot(input.linear, input.lateral); }

// Adds poses at even intervals to a motion with headings.
class Track {
 public:
  Track(SampledMotion& motion,
        std::array<double, SampledMotion::kMaxSamples>& headings,
        double start,
        double interval) noexcept
      : motion_(motion),
        headings_(headings) {
    motion_.start = start;
    motion_.interval = interval;
    motion_.count = 0;
  }

  void add(const Pose2& pose) noexcept {
    if (motion_.count >= SampledMotion::kMaxSamples) return;
    headings_[static_cast<std::size_t>(motion_.count)] = pose.heading;
    motion_.add(pose.position);
  }
  [[nodiscard]] bool full() const noexcept { return motion_.count >= SampledMotion::kMaxSamples; }

 private:
  SampledMotion& motion_;
  std::array<double, SampledMotion::kMaxSamples>& headings_;
};

}  // namespace

SharedMotion report_body(const BodyShape& body,
                         const DriveFollower& follower,
                         const Pose2& pose,
                         double time,
                         double period,
                         bool under_way) noexcept {
  const BaseModel& base = follower.base();
  const bool omni = base.kind == BaseKind::Omni;
  SharedMotion motion{
      .time = time,
      .position = pose.position,
      .speed = std::max(speed_of(follower.sent_before()), speed_of(follower.sent())),
      .radius = body.circumscribed_radius(),
      .speed_max = std::max(base.linear_max, -base.linear_min) + (omni ? base.lateral_max : 0.0),
      .acceleration = omni ? std::min(base.linear_acceleration, base.lateral_acceleration)
                           : base.linear_acceleration,
      .turn_max = base.angular_max};
  motion.outline.is_box = true;
  motion.outline.low = body.low();
  motion.outline.high = body.high();
  motion.under_way = under_way;
  // The stop: the response, the command, and its inputs, in as many periods per sample as fit.
  const BodyStop& stop = follower.proven_stop();
  const double sent_since = follower.periods_of_stop();
  const int left = std::max(0, static_cast<int>(std::ceil(stop.count - sent_since - 1e-6)));
  const int waiting = static_cast<int>(std::ceil(base.response_time / period));
  const int periods = waiting + 1 + left;
  const int every = (periods + SampledMotion::kMaxSamples - 2) / (SampledMotion::kMaxSamples - 1);
  Track stops(motion.stop, motion.outline.stop_headings, time, every * period);
  Pose2 now = pose;
  BaseInput from = follower.sent_before();
  stops.add(now);
  for (int k = 0; k < every * ((periods + every - 1) / every); ++k) {
    const int i = k - waiting - 1;
    const BaseInput to = i < -1     ? from
                         : i == -1  ? follower.sent()
                         : i < left ? stop.at(sent_since + i + 1)
                                    : resting_input(base, from);
    now = driven(base, now, from, to, period);
    from = to;
    if ((k + 1) % every == 0) stops.add(now);
  }
  constexpr double kPlanInterval = 0.1;  // [s]
  Track plans(motion.plan, motion.outline.plan_headings, time, kPlanInterval);
  if (!under_way) {
    plans.add(pose);
    return rounded(motion);
  }
  DriveProgress progress = follower.progress();
  while (!plans.full()) {
    const Pose2 at = follower.reference().pose_at(progress.phase);
    plans.add(at);
    progress = follower.reference().advanced(progress, 1.0, kPlanInterval);
  }
  // The way on, for robots that are discs.
  constexpr int kEvery = 10;
  for (int i = kEvery; i < motion.plan.count && motion.way.count < UpcomingWaypoints::kMaxPoints;
       i += kEvery)
    motion.way.points[static_cast<std::size_t>(motion.way.count++)] =
        motion.plan.positions[static_cast<std::size_t>(i)];
  return rounded(motion);
}

}  // namespace fairway
