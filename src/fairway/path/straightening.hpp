// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/path/travel_cost.hpp"

namespace fairway {

/// Turns a chain of neighbouring cells into a few straight lines without losing clearance.
///
/// A straight line replaces a part of the chain only if it costs no more and the robot fits along
/// it. TravelCost::line gives the cost, clearance included, and TravelCost::fits the test. Corners
/// are then moved, dropped and cut in two as long as this reduces the cost. The result never costs
/// more than the chain and is a local optimum. The first and the last point stay.
class Straightening {
 public:
  /// Replaces `points` [grid coordinates] in place. @pre the robot fits along each piece.
  void apply(const TravelCost& costs, std::vector<Eigen::Vector2d>& points);

 private:
  struct Corner {
    Eigen::Vector2d point;
    double cost = 0.0;  // of the line from the corner before [cells]
    double step = 0.0;  // distance by which the corner is moved next [cells]
  };

  void connect_lines_of_sight(const TravelCost& costs, const std::vector<Eigen::Vector2d>& points);
  bool move_corners(const TravelCost& costs);
  [[nodiscard]] static bool move_corner(const TravelCost& costs,
                                        const Eigen::Vector2d& before,
                                        Corner& corner,
                                        Corner& after);
  bool cut_corners(const TravelCost& costs);

  std::vector<double> cost_to_;  // cost of the chain up to every point
  std::vector<Corner> corners_;  // corners, both ends included
  std::vector<Corner> cut_;
};

}  // namespace fairway
