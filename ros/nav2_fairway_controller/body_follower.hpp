// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "fairway/navigation/body/body_navigator.hpp"
#include "nav2_fairway_controller/path_follower.hpp"

namespace fairway::nav2 {

/// The counterpart of PathFollower for a robot with its true outline on any base: the part of
/// Nav2's controller that does not depend on Nav2.
///
/// The path stays in its own frame; where that moves in the costmap's frame, the rest of the path
/// is followed again. A speed limit is a zone everywhere. As in PathFollower, the functions
/// `set_...`, `cancel` and `reset` may be called from any thread, except `set_body`.
class BodyFollower {
 public:
  /// @pre the settings are valid, and their model is not Disc.
  BodyFollower(const FollowerSettings& settings, const BodyShape& body);

  void set_settings(const FollowerSettings& settings) { mailbox_.post_settings(settings); }
  void set_path(PathTask task) { mailbox_.post_path(std::move(task)); }
  void set_speed_limit(const SpeedLimit& limit) { mailbox_.post_limit(limit); }
  void cancel() { mailbox_.post_cancel(); }
  void reset() { mailbox_.post_reset(); }

  /// Sets the body, between cycles. The same body again changes nothing.
  void set_body(const BodyShape& body);

  /// Runs one control cycle.
  [[nodiscard]] FollowerStep update(const FollowerInput& input);

  [[nodiscard]] const FollowerSettings& settings() const noexcept { return settings_; }
  [[nodiscard]] const Plan& plan() const noexcept { return navigator_->plan(); }

 private:
  void apply(FollowerChanges changes);
  void drop_path();
  void make_navigator();
  [[nodiscard]] bool update_frame(const FollowerInput& input);
  void update_speed(const FollowerInput& input);
  void follow_rest(const FollowerInput& input);
  [[nodiscard]] bool frame_has_moved() const noexcept;
  [[nodiscard]] FollowerStep judged(const NavigationStep& step, const FollowerInput& input);
  [[nodiscard]] std::string reason_of(const NavigationStep& step) const;

  FollowerMailbox mailbox_;
  FollowerSettings settings_;
  BodyShape body_;
  std::unique_ptr<BodyNavigator> navigator_;
  bool starts_ = true;  // the navigator does not know the robot's motion
  double sent_steering_ = 0.0;

  SpeedLimit limit_;
  double zone_speed_ = 0.0;  // 0: no zone
  bool holds_ = false;
  std::string limit_fault_;

  std::vector<PathPose> poses_;  // of the path, in its own frame
  std::vector<double> arcs_;     // of these [m]
  double begin_ = 0.0;           // arc at which the followed rest begins [m]
  bool follows_ = false;         // the navigator has the rest
  Pose2 frame_;                  // the path's frame in the costmap's
  Pose2 followed_frame_;         // when the rest was given to the navigator
  std::optional<double> frame_time_;
  double best_ = 0.0;
  std::optional<double> progress_time_;
};

/// Whether a path has the same poses.
[[nodiscard]] bool same_path(const std::vector<PathPose>& a,
                             const std::vector<PathPose>& b) noexcept;

}  // namespace fairway::nav2
