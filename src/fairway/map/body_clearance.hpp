// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/geometry/body_shape.hpp"
#include "fairway/geometry/robot_model.hpp"
#include "fairway/map/distance_field.hpp"

namespace fairway {

/// A place where a body is near an obstacle.
struct BodyContact {
  double distance = 0.0;  ///< from the body to the obstacle [m]; negative when they overlap
  Eigen::Vector2d point = Eigen::Vector2d::Zero();  ///< of the body, in the world [m]
  Eigen::Vector2d normal =
      Eigen::Vector2d::UnitX();  ///< from the obstacle to the body, in the world
};

/// Tests a body of any shape against the blocked cells of a map. It tests poses, and whole motions
/// from one pose to another.
///
/// Zones of the map count as well: keep-outs and strips. Cells and body are closed, and everything
/// outside the map is blocked. Every test is exact up to kFreeSpaceSkin (free_space.hpp), which
/// errs towards "blocked"; the distance field only decides what is far from every obstacle, or deep
/// in one. Nothing is allocated.
class BodyClearance {
 public:
  /// How much a motion's clearance may be underestimated [m]: see is_free for motions.
  static constexpr double kMotionTolerance = 5e-4;
  static constexpr int kMaxContacts = 16;

  /// Keeps references to both, which must outlive it. @pre `distances` was made from `obstacles`,
  /// and `body` has an area.
  BodyClearance(const BitGrid& obstacles, const DistanceField& distances, BodyShape body);

  [[nodiscard]] const BodyShape& body() const noexcept { return body_; }
  [[nodiscard]] const BitGrid& obstacles() const noexcept { return *obstacles_; }
  [[nodiscard]] const DistanceField& distances() const noexcept { return *distances_; }

  /// Whether every obstacle is further than `clearance` [m] from the body at `pose`. False for a
  /// pose that is not finite. @pre clearance >= 0.
  [[nodiscard]] bool is_free(const Pose2& pose, double clearance) const noexcept;

  /// As above, for all poses of the motion from `start` with constant `twist` for `duration` [s].
  ///
  /// The result is proven, not sampled. Where a pose has more clearance than any point of the body
  /// moves in half of an interval, the whole interval is free; otherwise the interval is halved.
  /// The result is also false where the clearance exceeds `clearance` by less than
  /// kMotionTolerance.
  [[nodiscard]] bool is_free(const Pose2& start,
                             const PlanarTwist& twist,
                             double duration,
                             double clearance) const noexcept;

  /// Returns the distance from the body at `pose` to the nearest obstacle, at most `limit` [m]. The
  /// result is at most 1e-4 m too small; it is 0 when they touch.
  [[nodiscard]] double distance(const Pose2& pose, double limit) const noexcept;

  /// A fast lower bound of `distance`, at least 0: from discs that cover the body [m].
  [[nodiscard]] double distance_bound(const Pose2& pose) const noexcept;

  /// Finds where the body is nearer than `reach` [m] to obstacles. It writes the nearest place of
  /// each corner region of the body and each direction to `found`, at most kMaxContacts.
  /// @return how many.
  [[nodiscard]] std::size_t contacts(const Pose2& pose,
                                     double reach,
                                     std::span<BodyContact> found) const noexcept;

 private:
  enum class Guess { Free, Blocked, Near };
  [[nodiscard]] Guess guess(const Pose2& local, double clearance) const noexcept;
  [[nodiscard]] bool is_free_exactly(const Pose2& local, double clearance) const noexcept;
  [[nodiscard]] bool is_free_part(const ConvexPart& part, double clearance) const noexcept;
  [[nodiscard]] ConvexPart part_in_grid(const ConvexPart& part, const Pose2& local) const noexcept;

  template <typename Look>
  void look_at_zones(const Pose2& local, double reach, const Look& look) const;

  // The pose in the frame of the grid, still in metres.
  [[nodiscard]] Pose2 in_grid_frame(const Pose2& pose) const noexcept;

  const BitGrid* obstacles_;
  const DistanceField* distances_;
  BodyShape body_;
  Eigen::Vector2d origin_direction_;
};

}  // namespace fairway
