// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/guide/guide_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fairway/path/se2/connections.hpp"
#include "fairway/planning/obstruction_text.hpp"

namespace fairway {

namespace {

// Poses along a path, at most some centimetres apart.
template <typename Visitor>
bool all_poses(const Pose2& start, const std::vector<MotionPiece>& pieces, const Visitor& visit) {
  constexpr double kApart = 0.05;  // [m], [rad]
  Pose2 pose = start;
  for (const MotionPiece& piece : pieces) {
    const int parts = std::max(1, static_cast<int>(std::ceil(piece.amount / kApart)));
    const MotionPiece part{.twist = piece.twist, .amount = piece.amount / parts};
    for (int i = 0; i < parts; ++i) {
      pose = part.from(pose);
      if (!visit(pose)) return false;
    }
  }
  return true;
}

class GuideSearch {
 public:
  GuideSearch(const BodyClearance& clearance,
              const BaseModel& base,
              const GuideTask& task,
              const BodyPathSettings& settings)
      : clearance_(clearance),
        base_(base),
        task_(task),
        guide_(*task.guide),
        settings_(settings),
        cost_(base, settings.reverse_factor, settings.cusp_factor),
        pose_(task.start),
        arc_(task.arc) {
    settings_.total_states = settings_.max_states = kStates;
    settings_.shortcut_tries = 40;
    path_.result.path.start = task.start;
    path_.result.margin = settings.margin;
  }

  GuidePath run() {
    const double end = last_place();
    constexpr double kNothing = 0.02;  // [m]
    const double length = guide_.length();
    if (end <= arc_ + kNothing && end < length) {
      path_.why = joined_text(
          {"the body does not fit on the path from ", place_text(guide_.at(arc_).position), " on"});
      return std::move(path_);
    }
    constexpr double kReached = 1e-6;
    bool first = true;
    while (first || arc_ < end - kReached) {
      first = false;
      if (!advance(end)) {
        path_.why =
            joined_text({"the base cannot follow the path from ", place_text(pose_.position), " on",
                         task_.may_leave ? "" : " within max_deviation"});
        break;
      }
    }
    merge_pieces(path_.result.path);
    path_.end = arc_;
    path_.complete = arc_ >= length - kReached;
    if (!path_.result.path.pieces.empty() || path_.complete)
      path_.result.status = BodyPathStatus::Found;
    return std::move(path_);
  }

 private:
  static constexpr int kStates = 30000;

  // A detour with the whole margin is better than a path along the guide with little, which a robot
  // can hardly follow.
  [[nodiscard]] bool advance(double end) {
    constexpr double kLess = 0.4;
    constexpr double kLeast = 0.1;
    const double margin = settings_.margin;
    return connect(end, margin) || (task_.may_leave && search(end)) ||
           connect(end, kLess * margin) || connect(end, kLeast * margin) ||
           (!task_.may_leave && search(end));
  }

  [[nodiscard]] double offset(const Pose2& pose, double from, double to) const noexcept {
    return guide_.band().nearest(pose.position, from, to).distance;
  }

  // The furthest place at which the body fits, not beyond a stop, which the optimisation would
  // move.
  [[nodiscard]] double last_place() const noexcept {
    constexpr double kStep = 0.1;  // [m]
    constexpr double kNear = 0.7;  // [m]
    const double stop = guide_.next_stop(arc_);
    double place = arc_ + task_.longest;
    if (stop - place < kNear) place = stop;
    while (place > arc_ && !clearance_.is_free(guide_.at(place), 0.5 * settings_.margin))
      place -= kStep;
    return std::max(place, arc_);
  }

  // How far a path from here may be from the guide.
  [[nodiscard]] double allowed() const noexcept {
    constexpr double kShare = 0.7;       // of the bound; the rest is for the optimisation
    constexpr double kReturning = 1.02;  // of the present offset
    const double now = offset(pose_, arc_ - 0.2, arc_ + 0.2);
    return std::max(kShare * task_.bound, now > kShare * task_.bound ? kReturning * now : 0.0);
  }

  [[nodiscard]] bool fits_gear(const Connection& connection, int gear) const noexcept {
    return gear == 0 || std::all_of(connection.pieces.begin(), connection.pieces.end(),
                                    [&](const MotionPiece& piece) {
                                      return piece.twist.linear * gear >= 0.0 ||
                                             piece.amount < 1e-3;
                                    });
  }

  [[nodiscard]] bool is_direct(const Connection& connection, double along) const noexcept {
    double length = 0.0;
    double turned = 0.0;
    for (const MotionPiece& piece : connection.pieces) {
      length += piece.amount * std::hypot(piece.twist.linear, piece.twist.lateral);
      turned += piece.amount * std::abs(piece.twist.angular);
    }
    constexpr double kLonger = 1.25;
    constexpr double kTurned = 1.5 * std::numbers::pi;
    return turned < kTurned &&
           length <= kLonger * along + 2.0 * offset(pose_, arc_ - 0.2, arc_ + 0.2) + 0.05;
  }

  [[nodiscard]] bool is_free(const Connection& connection, double margin) const noexcept {
    Pose2 pose = pose_;
    for (const MotionPiece& piece : connection.pieces) {
      if (!clearance_.is_free(pose, piece.twist, piece.amount, margin)) return false;
      pose = piece.from(pose);
    }
    return true;
  }

  void take(const std::vector<MotionPiece>& pieces, double place, double margin) {
    MotionPath& path = path_.result.path;
    path.pieces.insert(path.pieces.end(), pieces.begin(), pieces.end());
    for (const MotionPiece& piece : pieces)
      pose_ = piece.from(pose_);
    path_.result.margin = std::min(path_.result.margin, margin);
    arc_ = place;
  }

  // Drives on by the longest analytic connection that stays near the guide.
  [[nodiscard]] bool connect(double end, double margin) {
    constexpr std::array<double, 10> kSteps{3.0, 2.0, 1.4, 1.0, 0.7, 0.5, 0.35, 0.25, 0.15, 0.0};
    constexpr double kRest = 0.15;  // that is not left to a stop [m]
    const double stop = end;
    const int gear = guide_.gear_after(arc_);
    const double most = allowed();
    double before = -1.0;
    for (const double step : kSteps) {
      double place = std::min(arc_ + step, stop);
      if (stop - place < kRest) place = stop;
      if (place == before || (place <= arc_ && stop > arc_)) continue;
      before = place;
      find_connections(cost_, pose_, guide_.at(place), connections_);
      for (const Connection& connection : connections_) {
        const auto near = [&](const Pose2& pose) {
          return offset(pose, arc_ - 0.2, place + 0.2) <= most;
        };
        if (!fits_gear(connection, gear) || !is_direct(connection, place - arc_)) continue;
        if (!all_poses(pose_, connection.pieces, near) || !is_free(connection, margin)) continue;
        take(connection.pieces, place, margin);
        return true;
      }
    }
    return false;
  }

  // Drives on by the path of a search to a place ahead.
  [[nodiscard]] bool search(double end) {
    constexpr std::array<double, 4> kSteps{1.5, 3.0, 5.0, 8.0};
    double before = arc_;
    for (const double step : kSteps) {
      const double place = std::min(arc_ + step, end);
      if (place <= before && place < end) continue;
      if (place == before && step > kSteps.front()) break;
      before = place;
      const Pose2 target = guide_.at(place);
      if (!clearance_.is_free(target, 0.0)) continue;
      const BodyPathResult found = plan_body_path(clearance_, base_, pose_, target, settings_);
      path_.result.expanded += found.expanded;
      if (found.status != BodyPathStatus::Found) continue;
      const double most = allowed();
      const bool near = all_poses(pose_, found.path.pieces, [&](const Pose2& pose) {
        return offset(pose, arc_ - 0.5, place + 0.5) <= most;
      });
      if (!near && !task_.may_leave) continue;
      path_.within = path_.within && near;
      take(found.path.pieces, place, found.margin);
      return true;
    }
    return false;
  }

  const BodyClearance& clearance_;
  const BaseModel& base_;
  const GuideTask& task_;
  const Guide& guide_;
  BodyPathSettings settings_;
  MotionCost cost_;
  Pose2 pose_;
  double arc_;
  std::vector<Connection> connections_;
  GuidePath path_;
};

}  // namespace

GuidePath find_guide_path(const BodyClearance& clearance,
                          const BaseModel& base,
                          const GuideTask& task,
                          const BodyPathSettings& settings) {
  return GuideSearch(clearance, base, task, settings).run();
}

double guide_length_for(const BaseModel& base) noexcept {
  constexpr double kSeconds = 6.0;
  constexpr double kLeast = 3.0;  // [m]
  const double speed = std::max(base.linear_max, -base.linear_min);
  const double braking = speed * speed / (1.8 * base.linear_acceleration);
  return std::max({kLeast, kSeconds * speed, 3.0 * braking + 2.0 * speed});
}

}  // namespace fairway
