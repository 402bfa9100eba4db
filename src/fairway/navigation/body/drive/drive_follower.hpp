// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/geometry/robot_model.hpp"
#include "fairway/navigation/body/control/body_control.hpp"
#include "fairway/navigation/body/proof/body_stop.hpp"
#include "fairway/navigation/navigation_status.hpp"
#include "fairway/safety/safety_settings.hpp"
#include "fairway/trajectory/tracking_law.hpp"

namespace fairway {

/// Time in which a robot looks at moving obstacles [s]: steered bases need longer to give way.
[[nodiscard]] constexpr double look_ahead_of(const BaseModel& base) noexcept {
  return is_steered(base) ? 8.0 : 5.0;
}

/// What a follower measures in a cycle.
struct FollowerView {
  Pose2 pose;
  const BodyClearance* clearance = nullptr;  ///< the newest static obstacles
  MovingSurroundings moving;
  bool no_refuge = false;  ///< there is no drive out of the way of an obstacle
  /// Control that may leave the drive where that costs less; null for none.
  BodyControl* control = nullptr;
};

/// What a follower answers.
struct FollowerStep {
  BaseInput input;  ///< until the next cycle
  NavigationStatus status = NavigationStatus::Ok;
  LimitingFactor limit = LimitingFactor::None;
};

/// How a cycle lies in time, and how the cycles of the last seconds did.
struct FollowerCycle {
  double elapsed = 0.1;    ///< since the cycle before [s]
  double longest = 0.0;    ///< longest time to the next cycle that is promised, or occurred [s]
  double shortest = 0.1;   ///< shortest one that occurred, or a period [s]
  bool irregular = false;  ///< whether cycles were noticeably early or late
};

/// The next motion of a robot.
struct DriveLead {
  Trajectory ahead;  ///< along the present drive; without steps for none
  Trajectory stop;   ///< after that, to rest; without steps where the robot is at rest
};

/// Drives a robot of any base along a planned drive, as fast as it is planned or slower.
///
/// In every cycle the follower selects the rate of the drive so that moving obstacles are avoided.
/// It corrects for deviations, and proves the stop after its command with the true body. A command
/// whose stop is not proven is not sent: the last proven stop is executed instead. Does not
/// allocate.
class DriveFollower {
 public:
  DriveFollower(const BaseModel& base, double period, const SafetySettings& safety) noexcept
      : base_(base),
        period_(period),
        look_ahead_(look_ahead_of(base)),
        safety_(safety),
        cycle_({.elapsed = period, .longest = period, .shortest = period}),
        step_(period),
        ramp_(period) {}

  /// Takes over a drive, from its begin. @pre the robot is at rest at the drive's start.
  /// @param evasive  It leads out of the predicted motion of obstacles; see `gives_way`.
  void follow(DriveReference reference, bool evasive = false) noexcept;

  /// Takes over a drive in motion: the robot is at `phase` of it. The stop proven last is kept.
  void follow_moving(DriveReference reference, double phase) noexcept;

  /// Returns what the robot does next: it drives along its drive for a time, then it stops there. A
  /// drive that begins in motion begins with this. Allocates.
  /// @param ahead  That time [s], as a multiple of `step`.
  /// @param step   Time between knots [s].
  [[nodiscard]] DriveLead lead(const Pose2& pose, double ahead, double step) const;

  /// Sets the free space along the present drive, in which control may leave it.
  void set_space(DriveSpace space) noexcept { space_ = std::move(space); }

  /// Limits the rate of the present drive; see DriveReference::limit_rate.
  void limit_rate(std::vector<double> most) { reference_.limit_rate(std::move(most)); }

  /// Sets the actual input of the base, for one that was moved by other means. Drops the drive.
  void reset(const BaseInput& actual) noexcept;

  /// Sets the input that was really sent in this cycle, where a later check has changed it. The
  /// drive is kept; until a stop is proven again the robot brakes.
  void replace_last(const BaseInput& sent) noexcept;

  /// Changes the time between commands and the safety settings; drive and motion are kept.
  void set_settings(double period, const SafetySettings& safety) noexcept;

  /// One cycle along the drive.
  [[nodiscard]] FollowerStep update(const FollowerView& view) noexcept;

  /// One cycle of the last proven stop, without any measurement. Without a stop it brakes. The stop
  /// is a function of time: late cycles do not make it longer.
  [[nodiscard]] BaseInput stop() noexcept;

  /// One cycle of braking along the drive.
  [[nodiscard]] FollowerStep brake(const FollowerView& view) noexcept;

  /// Begins a control cycle: the base has followed what it was sent. Call it before the others.
  void begin_cycle(const FollowerCycle& cycle) noexcept;

  [[nodiscard]] bool at_rest() const noexcept;
  /// Whether a robot at `pose` is too far from where the drive has it.
  [[nodiscard]] bool is_lost(const Pose2& pose) const noexcept;
  [[nodiscard]] bool finished() const noexcept { return progress_.phase >= reference_.duration(); }
  /// Whether the drive is finished, and what was left to its end is closed as far as possible.
  [[nodiscard]] bool settled() const noexcept { return settled_ && at_rest(); }
  [[nodiscard]] const DriveProgress& progress() const noexcept { return progress_; }
  [[nodiscard]] const DriveReference& reference() const noexcept { return reference_; }
  [[nodiscard]] const BaseInput& sent() const noexcept { return sent_; }
  /// The input of the cycle before.
  [[nodiscard]] const BaseInput& sent_before() const noexcept { return sent_before_; }
  /// The last stop that was proven, and the periods since its first input was sent.
  [[nodiscard]] const BodyStop& proven_stop() const noexcept { return proven_; }
  [[nodiscard]] double periods_of_stop() const noexcept { return since_ / period_; }
  [[nodiscard]] const BaseModel& base() const noexcept { return base_; }

 private:
  struct Choice {
    double target = 1.0;
    bool slowed = false;  // by a moving obstacle
  };
  struct Candidate {
    DriveProgress progress;
    DriveProgress sent_for;  // where the robot is when the base has followed the input
    BaseInput input;
    bool controlled = false;  // by model predictive control: it stops beside its drive
    double separation = 0.0;  // least distance to moving obstacles then, less what is kept [m]
  };
  [[nodiscard]] bool steers_first() noexcept;
  [[nodiscard]] FollowerStep settle(const FollowerView& view) noexcept;
  [[nodiscard]] double accuracy(const Pose2& pose) const noexcept;
  [[nodiscard]] Choice choose_rate(const FollowerView& view) const noexcept;
  [[nodiscard]] BaseInput within_zones(const FollowerView& view, BaseInput input) const noexcept;
  [[nodiscard]] Candidate candidate(const FollowerView& view, double target) const noexcept;
  [[nodiscard]] bool may_control(const FollowerView& view) const noexcept;
  [[nodiscard]] std::optional<Candidate> controlled(const FollowerView& view,
                                                    double target) noexcept;
  [[nodiscard]] std::optional<NavigationStatus> drive_beside(const FollowerView& view,
                                                             double target) noexcept;
  [[nodiscard]] double separation_at_rest(const FollowerView& view) const noexcept;
  void find_place(const Pose2& pose) noexcept;
  [[nodiscard]] bool escape(const FollowerView& view) noexcept;
  [[nodiscard]] bool stop_is_free(const FollowerView& view) noexcept;
  [[nodiscard]] StopSurroundings surroundings(const FollowerView& view) const noexcept;
  // What a proof excuses.
  enum class Excuse { None, BrakesInZone, GivesWay };
  [[nodiscard]] StopVerdict prove(const FollowerView& view,
                                  const Candidate& next,
                                  Excuse excuse = Excuse::None) noexcept;
  [[nodiscard]] double backing_rate() const noexcept;
  [[nodiscard]] bool can_leave(const FollowerView& view, const Candidate& next) const noexcept;
  [[nodiscard]] bool gives_way(const FollowerView& view, double target) noexcept;
  [[nodiscard]] BodyManoeuvre manoeuvre(const BaseInput& input) const noexcept;
  void take(const Candidate& next) noexcept;
  void send(const BaseInput& input) noexcept;

  BaseModel base_;
  double period_;
  double look_ahead_;  // [s]
  SafetySettings safety_;
  TrackingGains gains_{};
  DriveReference reference_;
  DriveSpace space_;
  DriveProgress progress_;
  bool controlled_ = false;  // the last input was of model predictive control
  double beside_ = 0.0;      // time for which it may be beside its drive [s]
  FollowerCycle cycle_;
  double step_;         // in which the input may change in this cycle [s]
  double ramp_;         // in which the base ramps to what was sent [s]
  double since_ = 0.0;  // the time since the first input of the proven stop was sent [s]
  BaseInput sent_;
  BaseInput sent_before_;
  BaseInput current_;  // of a base that ramps evenly
  BaseInput quick_;    // of one that changes as hard as it can
  bool evasive_ = false;
  bool settled_ = false;
  int settling_cycles_ = 0;
  BodyStop proven_;
  BodyStop trial_;
};

}  // namespace fairway
