// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace fairway {

/// Where people appear at a site: doors, corners, edges of what is observed.
///
/// The map counts appearances per place, and how long the site was observed. Its rate is how often
/// a person is to be expected to appear so near to a place that a robot there could not react.
class EntranceMap {
 public:
  /// Makes an empty map of a region, in cells of 0.25 m. Allocates; the other functions do not.
  /// Outside the region no person is expected.
  /// @pre low <= high, and a side is at most 1 km long.
  EntranceMap(const Eigen::Vector2d& low, const Eigen::Vector2d& high);

  /// Notes that a person appeared. A place outside the region is ignored.
  void note(const Eigen::Vector2d& place) noexcept;

  /// Notes that the site was observed for `duration` more seconds.
  void observe(double duration) noexcept { observed_ += duration; }

  /// Returns the expected number of appearances near a place per second [1/s].
  [[nodiscard]] double rate(double x, double y) const noexcept;

 private:
  Eigen::Vector2d low_;
  std::size_t width_;
  std::size_t height_;
  std::vector<double> counts_;  // of appearances near the middle of a cell, row by row
  double observed_ = 0.0;       // [s]
};

}  // namespace fairway
