// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/path/travel_cost.hpp"

namespace fairway {

/// Turns a chain of neighbouring cells into a few straight lines, without giving up the clearance
/// that the search paid for.
///
/// A straight line replaces a part of the chain only if it costs no more, clearance counted
/// (TravelCost::line), and the robot fits along it (TravelCost::fits). Then corners are moved,
/// dropped and cut in two, as long as that makes the way cheaper. So the result never costs more
/// than the chain, and locally nothing is left to gain. First and last point stay.
class Straightening {
 public:
  /// Replaces `points` [grid coordinates]. @pre the robot fits along each piece.
  void apply(const TravelCost& costs, std::vector<Eigen::Vector2d>& points);

 private:
  struct Corner {
    Eigen::Vector2d point;
    double cost = 0.0;  // of the line from the corner before [cells]
    double step = 0.0;  // by which it is moved next [cells]
  };

  void pull_string(const TravelCost& costs, const std::vector<Eigen::Vector2d>& points);
  bool move_corners(const TravelCost& costs);
  [[nodiscard]] static bool move_corner(const TravelCost& costs,
                                        const Eigen::Vector2d& before,
                                        Corner& corner,
                                        Corner& after);
  bool cut_corners(const TravelCost& costs);

  std::vector<double> cost_to_;  // of every point, along the chain
  std::vector<Corner> corners_;  // ends included
  std::vector<Corner> cut_;
};

}  // namespace fairway
