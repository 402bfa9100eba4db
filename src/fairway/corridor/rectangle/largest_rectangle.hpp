// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include "fairway/corridor/rectangle/box_repair.hpp"

namespace fairway {

/// A point that a rectangle must contain, at least `margin` inside every side. Coordinates are in
/// the world [m] or in the grid [cells], as stated where it is used.
struct Anchor {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  double margin = 0.0;
};

/// Effort of the search over orientations.
struct RectangleSearchSettings {
  double longest_side = 16.0;  ///< greatest length of a side [m]
  /// Orientations tried at first, evenly over a quarter turn; at most 64.
  int num_orientations = 12;
  int refinements = 4;  ///< number of times that the spacing is halved around the best orientation
  double tolerance = 0.01;  ///< relative gain in area below which the search stops
};

/// Finds the largest free rectangle that contains given points, over all orientations.
///
/// The search is best first. A growing set of known obstacle points gives an upper bound on the
/// area for each orientation (largest_box). Only the orientation with the greatest bound is tested
/// on the map, exactly; the obstacles that it meets are added to the points, and the next best is
/// tried. The result is optimal over the orientations tried, up to `tolerance` and to a budget of
/// tests that only mazes exhaust. The result is always free by is_free.
///
/// Only scratch memory persists between calls: equal arguments give equal bits.
class RectangleSearch {
 public:
  /// A free rectangle in grid coordinates: `box` in `frame`, whose origin is the first anchor.
  struct Found {
    TurnedFrame frame;
    Box box;
  };

  /// Finds the largest free rectangle that contains every anchor; none if no orientation tried has
  /// one.
  /// @param clearance  0 in workspace, the robot's radius in configuration space [m].
  /// @param anchors  In grid coordinates [cells]. @pre not empty.
  /// @param hint  An additional orientation to try, relative to the grid [rad].
  [[nodiscard]] std::optional<Found> find(const BitGrid& obstacles,
                                          double clearance,
                                          std::span<const Anchor> anchors,
                                          const RectangleSearchSettings& settings,
                                          std::optional<double> hint = std::nullopt) noexcept;

  /// Number of rectangles that the last search tested on the map.
  [[nodiscard]] int tests() const noexcept { return tests_; }

 private:
  struct Candidate {
    double angle = 0.0;  // of the frame relative to the grid [rad]
    Eigen::Vector2d along = Eigen::Vector2d::UnitX();
    Box core;
    Box box;
    double bound = 0.0;     // upper bound on the area of a free box at this angle [cells^2]
    std::size_t known = 0;  // number of obstacle points checked; none of them lies in `box`
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
  // Area from which on a candidate is worth testing [cells^2].
  [[nodiscard]] double worthwhile() const noexcept { return best_area_ * (1.0 + tolerance_); }

  double best_area_ = 0.0;
  double best_angle_ = 0.0;
  Found best_;
  int tests_ = 0;
};

/// Finds the largest free rectangle that contains `seed` and `others`, all in the world [m].
/// `is_free` with `clearance` holds for it, and its seed is `seed`. The result is none if the seed
/// is not free or not finite, or if no rectangle can contain all points.
[[nodiscard]] std::optional<OrientedRectangle> largest_rectangle(
    const BitGrid& obstacles,
    double clearance,
    const Anchor& seed,
    std::span<const Anchor> others = {},
    const RectangleSearchSettings& settings = {});

}  // namespace fairway
