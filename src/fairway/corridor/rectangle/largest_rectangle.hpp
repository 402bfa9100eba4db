// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include "fairway/corridor/rectangle/box_repair.hpp"

namespace fairway {

/// A point that a rectangle must hold, at least `margin` inside every side. In the world [m] or in
/// grid coordinates [cells], as said where it is used.
struct Anchor {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  double margin = 0.0;
};

/// How thoroughly orientations are searched.
struct RectangleSearchSettings {
  double longest_side = 16.0;  ///< no side gets longer [m]
  int num_orientations = 12;   ///< turns tried at first, evenly over a quarter turn; at most 64
  int refinements = 4;         ///< times the spacing is halved around the best turn
  double tolerance = 0.01;     ///< share of area at which a possible gain is not pursued
};

/// Finds the largest free rectangle that holds given points, over all orientations.
///
/// Best first: what is known about the obstacles, a growing set of points, gives for each
/// orientation an upper bound on the area (largest_box). Only the orientation with the greatest
/// bound is tested on the map, exactly; the obstacles that it meets are added to the known points,
/// and the next best is tried. What remains at the end is, at every orientation tried, the optimum
/// up to `tolerance` (and to a budget of tests, which only mazes exhaust). The result is free by
/// is_free whatever happened before.
///
/// Keeps only scratch memory between calls: equal arguments give equal bits.
class RectangleSearch {
 public:
  /// A free rectangle in grid coordinates: `box` in `frame`, whose origin is the first anchor.
  struct Found {
    TurnedFrame frame;
    Box box;
  };

  /// The largest free rectangle that holds every anchor; none when no orientation tried has one.
  /// @param clearance  0 in workspace, the robot's radius in configuration space [m].
  /// @param anchors  In grid coordinates [cells]. @pre not empty.
  /// @param hint  An orientation against the grid to try as well [rad].
  [[nodiscard]] std::optional<Found> find(const BitGrid& obstacles,
                                          double clearance,
                                          std::span<const Anchor> anchors,
                                          const RectangleSearchSettings& settings,
                                          std::optional<double> hint = std::nullopt) noexcept;

  /// How many rectangles the last search tested on the map.
  [[nodiscard]] int tests() const noexcept { return tests_; }

 private:
  struct Candidate {
    double angle = 0.0;  // of the frame against the grid [rad]
    Eigen::Vector2d along = Eigen::Vector2d::UnitX();
    Box core;
    Box box;
    double bound = 0.0;     // no free box at this angle is larger, or worth it [cells^2]
    std::size_t known = 0;  // obstacle points, of which none lies in `box`
    int tests = 0;
  };

  void try_angle(double angle) noexcept;
  void evaluate(Candidate& candidate) noexcept;
  [[nodiscard]] bool is_up_to_date(Candidate& candidate) const noexcept;
  void test(const BitGrid& obstacles, Candidate& candidate) noexcept;
  void exhaust(const BitGrid& obstacles) noexcept;
  void learn(const BoxRepair& repair, const Box& box, std::span<const CellIndex> cells) noexcept;
  bool accept_if_free(const BitGrid& obstacles,
                      const Candidate& candidate,
                      const Box& box) noexcept;

  static constexpr std::size_t kMaxCandidates = 96;

  std::span<const Anchor> anchors_;
  const GridFrame* grid_ = nullptr;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  double radius_ = 0.0;
  double longest_ = 0.0;
  double tolerance_ = 0.0;
  ObstaclePoints points_;
  std::array<Candidate, kMaxCandidates> candidates_;
  std::size_t num_candidates_ = 0;
  // An area that is worth to go on for [cells^2].
  [[nodiscard]] double worthwhile() const noexcept { return best_area_ * (1.0 + tolerance_); }

  double best_area_ = 0.0;
  double best_angle_ = 0.0;
  Found best_;
  int tests_ = 0;
};

/// The largest free rectangle that holds `seed` and `others`, all in the world [m]: `is_free` with
/// `clearance` holds for it. None when the seed is not free, or not finite, or no rectangle has
/// room for all of them. Its seed is `seed`.
[[nodiscard]] std::optional<OrientedRectangle> largest_rectangle(
    const BitGrid& obstacles,
    double clearance,
    const Anchor& seed,
    std::span<const Anchor> others = {},
    const RectangleSearchSettings& settings = {});

}  // namespace fairway
