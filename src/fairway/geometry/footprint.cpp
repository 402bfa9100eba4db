// SPDX-License-Identifier: Apache-2.0
#include "fairway/geometry/footprint.hpp"

#include <algorithm>
#include <limits>

#include "fairway/base/contract.hpp"

namespace fairway {

using Eigen::Vector2d;

Footprint Footprint::disc(double radius) noexcept {
  const Disc only{.center = {0, 0}, .radius = radius};
  return discs(&only, 1);
}

Footprint Footprint::discs(const Disc* discs, int count) noexcept {
  FAIRWAY_EXPECTS(count >= 1 && count <= kMaxDiscs);
  Footprint footprint;
  footprint.count_ = count;
  std::copy_n(discs, count, footprint.discs_.begin());
  footprint.measure();
  return footprint;
}

Footprint Footprint::rectangle(double length, double width, const Vector2d& offset) noexcept {
  Footprint footprint;
  footprint.low_ = offset - 0.5 * Vector2d(length, width);
  footprint.high_ = offset + 0.5 * Vector2d(length, width);
  footprint.measure();
  return footprint;
}

void Footprint::measure() noexcept {
  circumscribed_ = low_.cwiseAbs().cwiseMax(high_.cwiseAbs()).norm();
  for (int i = 0; i < count_; ++i)
    circumscribed_ = std::max(circumscribed_, disc_at(i).center.norm() + disc_at(i).radius);
}

double Footprint::inscribed_radius() const noexcept {
  if (is_rectangle()) return std::max(0.0, std::min((-low_).minCoeff(), high_.minCoeff()));
  double best = 0.0;
  for (int i = 0; i < count_; ++i)
    best = std::max(best, disc_at(i).radius - disc_at(i).center.norm());
  return best;
}

Footprint Footprint::shrunk(double amount) const noexcept {
  Footprint smaller = *this;
  for (int i = 0; i < count_; ++i) {
    double& radius = smaller.discs_[static_cast<std::size_t>(i)].radius;
    radius = std::max(0.0, radius - amount);
  }
  const Vector2d middle = 0.5 * (low_ + high_);
  smaller.low_ = (low_.array() + amount).min(middle.array());
  smaller.high_ = (high_.array() - amount).max(middle.array());
  smaller.measure();
  return smaller;
}

double Footprint::distance(const Vector2d& local) const noexcept {
  if (is_rectangle()) return (local - local.cwiseMax(low_).cwiseMin(high_)).norm();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count_; ++i) {
    least = std::min(least, std::max(0.0, (local - disc_at(i).center).norm() - disc_at(i).radius));
  }
  return least;
}

}  // namespace fairway
