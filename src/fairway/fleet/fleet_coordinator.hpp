// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/fleet/retreat_path.hpp"
#include "fairway/prediction/shared_motion.hpp"

namespace fairway {

/// What a FleetCoordinator is told in a cycle.
struct FleetCoordinatorInput {
  double speed_max = 0.0;   ///< of the robot [m/s]
  double radius = 0.0;      ///< of the disc that covers it [m]
  bool standing = false;    ///< whether it stands
  double dt = 0.0;          ///< length of a cycle [s]
  std::uint32_t robot = 0;  ///< its number in the fleet
  Fleet fleet;
  const BitGrid* obstacles = nullptr;
};

/// The way of a robot among robots: where straight ways would meet, all go round the same point on
/// the same side.
///
/// Two ways meet where both robots, driving straight on at full speed, would come nearer than their
/// bodies and some room. Two that meet nearly head-on, or three and more, go round the mean of
/// where they meet, on a circle that has room for all of them. Of roundabouts that overlap each
/// robot takes the largest that it knows, so that all come to the same. Who stands on the way round
/// makes it wider. A roundabout is left when the straight way on no longer leads through it.
///
/// Where two ways meet head-on in a place too narrow to pass, one robot steps aside and waits: the
/// one that can, of two that can the one that is further from that place, of two as near the one
/// with the greater number. Where none can, the one with the shorter way back to a place where it
/// lets the other pass goes back there; of equal ones the one with the greater number. Who is
/// followed by another one counts its way back, too, if that is longer. Where two enter a narrow
/// place the same way at the same time, the nearer one goes first. Who has waited for long for
/// somebody who does not come tries to go on.
class FleetCoordinator {
 public:
  void reset() noexcept { *this = FleetCoordinator(); }

  /// Tells that the way to the goal has changed. Who waits for others goes on doing so.
  void change_way() noexcept { roundabout_ = {}; }

  /// @param string  The way of the robot alone, from where it is.
  /// @return The string to follow; lives until the next call.
  const ReferencePath& update(const ReferencePath& path,
                              const FleetCoordinatorInput& input) noexcept;

  [[nodiscard]] const Roundabout& roundabout() const noexcept { return roundabout_; }
  /// Whether the robot waits aside for others, or is on its way there.
  [[nodiscard]] bool waits() const noexcept { return waits_; }
  [[nodiscard]] double distance_to_bottleneck() const noexcept { return distance_to_bottleneck_; }
  [[nodiscard]] bool can_step_aside() const noexcept { return can_step_aside_; }
  /// See SharedMotion::retreat_length.
  [[nodiscard]] double retreat_length() const noexcept { return retreat_length_; }

 private:
  [[nodiscard]] static Roundabout meet(const ReferencePath& path,
                                       const FleetCoordinatorInput& input) noexcept;
  void give_way_to(const Roundabout& other) noexcept;
  [[nodiscard]] bool steps_aside(const ReferencePath& path,
                                 const FleetCoordinatorInput& input) noexcept;
  [[nodiscard]] bool is_nearer(const SharedMotion& other, std::uint32_t robot) const noexcept;
  [[nodiscard]] bool goes_before(const SharedMotion& other, std::uint32_t robot) const noexcept;
  void look_back(const Eigen::Vector2d& here, const PassingEnvironment& around, double dt) noexcept;
  [[nodiscard]] double cost_of_back(const Eigen::Vector2d& here,
                                    const PassingEnvironment& around) noexcept;
  void lead_back(const Eigen::Vector2d& here) noexcept;

  Roundabout roundabout_;
  ReferencePath path_;
  double standing_ = 0.0;      // on the way round [s]
  RetreatPath back_;           // to where it waits, or would
  bool waits_ = false;         // it is on it, or at its end
  double since_search_ = 1e9;  // for a way back [s]
  double retreat_length_ = 0.0;
  double distance_to_bottleneck_ = std::numeric_limits<double>::infinity();
  bool can_step_aside_ = true;
  double waited_ = 0.0;  // [s]; negative: not again yet
};

}  // namespace fairway
