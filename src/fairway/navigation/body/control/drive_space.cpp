// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/control/drive_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fairway/geometry/angle.hpp"
#include "fairway/trajectory/tracking_law.hpp"

namespace fairway {

std::optional<BodyCorridor::Pair> DriveSpace::at(double phase) const noexcept {
  if (knots.empty()) return std::nullopt;
  const auto after = std::lower_bound(knots.begin(), knots.end(), phase);
  auto k = static_cast<int>(after - knots.begin());
  if (after == knots.end() || (k > 0 && phase - *(after - 1) < *after - phase)) --k;
  return corridor.at(k);
}

double DriveSpace::stop_after(double phase) const noexcept {
  const auto stop = std::upper_bound(stops.begin(), stops.end(), phase);
  return stop != stops.end() ? *stop : stops.empty() ? phase : stops.back();
}

DriveSpace find_drive_space(const BitGrid& obstacles,
                            const BodyShape& body,
                            const BaseModel& base,
                            std::span<const TrajectoryRow> rows,
                            double period,
                            double margin) {
  constexpr double kApart = 0.1;   // between poses [m]
  constexpr double kTurned = 0.1;  // and [rad]
  constexpr double kSlow = 0.02;   // [m/s], [rad/s]: the drive changes gear there
  DriveSpace space{.body = SlicedBody::of(body.low(), body.high()), .corridor = {}};
  std::vector<Pose2> poses;
  bool moves = false;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double phase = period * static_cast<double>(k);
    const TrajectoryRow& row = rows[k];
    const PlanarTwist& twist = row.twist;
    if (poses.empty() || k + 1 == rows.size() ||
        (row.pose.position - poses.back().position).norm() >= kApart ||
        std::abs(shortest_turn(poses.back().heading, row.pose.heading)) >= kTurned) {
      poses.push_back(row.pose);
      space.knots.push_back(phase);
    }
    const bool turns_back =
        k > 0 && base.kind != BaseKind::Omni && twist.linear * rows[k - 1].twist.linear < 0.0;
    const bool slow =
        std::hypot(twist.linear, twist.lateral) < kSlow && std::abs(twist.angular) < kSlow;
    if (turns_back || (slow && moves)) space.stops.push_back(phase);
    moves = !slow;
  }
  const double end = period * static_cast<double>(rows.size() - 1);
  if (space.stops.empty() || space.stops.back() < end) space.stops.push_back(end);
  space.corridor = build_body_corridor(obstacles, space.body, poses, margin);
  return space;
}

double nearest_phase(const DriveReference& drive,
                     const Pose2& pose,
                     double from,
                     double to) noexcept {
  constexpr double kStep = 0.04;   // [s]
  constexpr double kLever = 0.25;  // of a turn, squared [m^2]
  double best = from;
  double least = std::numeric_limits<double>::infinity();
  for (double phase = from; phase <= to; phase += kStep) {
    const Pose2 at = drive.pose_at(phase);
    const double turn = shortest_turn(at.heading, pose.heading);
    const double apart = (at.position - pose.position).squaredNorm() + kLever * turn * turn;
    if (apart >= least) continue;
    least = apart;
    best = phase;
  }
  return best;
}

}  // namespace fairway
