// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/se2/motion_path.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

Pose2 MotionPath::end() const noexcept {
  Pose2 pose = start;
  for (const MotionPiece& piece : pieces)
    pose = piece.from(pose);
  return pose;
}

double MotionPath::length() const noexcept {
  double sum = 0.0;
  for (const MotionPiece& piece : pieces)
    sum += piece.amount * std::hypot(piece.twist.linear, piece.twist.lateral);
  return sum;
}

bool same_direction(const MotionPiece& a, const MotionPiece& b) noexcept {
  constexpr double kEqual = 1e-9;
  return std::abs(a.twist.linear - b.twist.linear) < kEqual &&
         std::abs(a.twist.lateral - b.twist.lateral) < kEqual &&
         std::abs(a.twist.angular - b.twist.angular) < kEqual;
}

void merge_pieces(MotionPath& path) {
  std::vector<MotionPiece> merged;
  for (const MotionPiece& piece : path.pieces) {
    if (piece.amount < 1e-9) continue;
    if (!merged.empty() && same_direction(merged.back(), piece)) {
      merged.back().amount += piece.amount;
    } else {
      merged.push_back(piece);
    }
  }
  path.pieces = std::move(merged);
}

MotionPath reversed(const MotionPath& path) {
  MotionPath back{.start = path.end(), .pieces = {path.pieces.rbegin(), path.pieces.rend()}};
  for (MotionPiece& piece : back.pieces)
    piece.twist = -1.0 * piece.twist;
  return back;
}

MotionCost::MotionCost(const BaseModel& base, double reverse_factor, double cusp_factor)
    : base_(base),
      reverse_factor_(reverse_factor),
      cusp_factor_(cusp_factor) {
  // Manoeuvres are short: over a metre a base reaches no more than this speed.
  constexpr double kStroke = 1.0;  // [m]
  const double speed = std::min(base.linear_max, std::sqrt(base.linear_acceleration * kStroke));
  pause_ = speed / base.linear_acceleration;
  double fastest = std::max(base.linear_max, -base.linear_min);
  if (base.kind == BaseKind::Omni) fastest = std::hypot(fastest, base.lateral_max);
  per_metre_ = 1.0 / fastest;
  per_radian_ = 1.0 / base.angular_max;
}

double MotionCost::of(const MotionPiece& piece) const noexcept {
  const double factor = piece.twist.linear < 0.0 ? reverse_factor_ : 1.0;
  return factor * piece.amount * speed_load(base_, piece.twist);
}

double MotionCost::between(const MotionPiece& before, const MotionPiece& after) const noexcept {
  if (same_direction(before, after)) return 0.0;
  const PlanarTwist& a = before.twist;
  const PlanarTwist& b = after.twist;
  if (is_steered(base_)) {
    const double from = std::atan(base_.wheelbase * a.angular / a.linear);
    const double to = std::atan(base_.wheelbase * b.angular / b.linear);
    const double steering = std::abs(to - from) / base_.steering_rate_max;
    if (a.linear * b.linear < 0.0) return cusp_factor_ * std::max(pause_, steering);
    return 0.6 * steering;
  }
  const double pace_a = std::hypot(a.linear, a.lateral);
  const double pace_b = std::hypot(b.linear, b.lateral);
  if (pace_a <= 0.0 || pace_b <= 0.0) return 0.5 * pause_ + 0.1;
  const double aligned = (a.linear * b.linear + a.lateral * b.lateral) / (pace_a * pace_b);
  const double turning = 0.15 * std::abs(a.angular - b.angular) / base_.angular_acceleration;
  return 0.5 * pause_ * (1.0 - aligned) + turning;
}

double MotionCost::of(const std::vector<MotionPiece>& pieces) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    sum += of(pieces[i]) + (i > 0 ? between(pieces[i - 1], pieces[i]) : 0.0);
  return sum;
}

}  // namespace fairway
