// SPDX-License-Identifier: Apache-2.0
#include "fairway/prediction/entrances.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

namespace {

constexpr double kCell = 0.25;       // [m]
constexpr double kInner = 0.5;       // an appearance counts in full up to this distance [m]
constexpr double kOuter = 1.1;       // and not at all from this one [m]
constexpr double kLeastTime = 30.0;  // as if the site had been observed for so long [s]

std::size_t cells(double length) noexcept {
  constexpr double kMost = 4000.0;
  return static_cast<std::size_t>(std::clamp(std::ceil(length / kCell), 1.0, kMost));
}

}  // namespace

EntranceMap::EntranceMap(const Eigen::Vector2d& low, const Eigen::Vector2d& high)
    : low_(low),
      width_(cells(high.x() - low.x())),
      height_(cells(high.y() - low.y())),
      counts_(width_ * height_, 0.0) {}

void EntranceMap::note(const Eigen::Vector2d& place) noexcept {
  const Eigen::Vector2d at = (place - low_) / kCell;
  const double width = static_cast<double>(width_);
  const double height = static_cast<double>(height_);
  constexpr double kReach = kOuter / kCell + 1.0;
  if (!(at.x() > -kReach && at.x() < width + kReach && at.y() > -kReach &&
        at.y() < height + kReach))
    return;
  const auto first = [](double value, double most) {
    return static_cast<std::size_t>(std::clamp(value - kReach, 0.0, most));
  };
  const auto last = [](double value, double most) {
    return static_cast<std::size_t>(std::clamp(value + kReach, 0.0, most));
  };
  for (std::size_t j = first(at.y(), height); j < last(at.y(), height); ++j) {
    for (std::size_t i = first(at.x(), width); i < last(at.x(), width); ++i) {
      const double dx = (static_cast<double>(i) + 0.5 - at.x()) * kCell;
      const double dy = (static_cast<double>(j) + 0.5 - at.y()) * kCell;
      const double share = (kOuter - std::sqrt(dx * dx + dy * dy)) / (kOuter - kInner);
      counts_[j * width_ + i] += std::clamp(share, 0.0, 1.0);
    }
  }
}

double EntranceMap::rate(double x, double y) const noexcept {
  const double u = (x - low_.x()) / kCell;
  const double v = (y - low_.y()) / kCell;
  if (!(u >= 0.0 && v >= 0.0 && u < static_cast<double>(width_) &&
        v < static_cast<double>(height_)))
    return 0.0;
  return counts_[static_cast<std::size_t>(v) * width_ + static_cast<std::size_t>(u)] /
         std::max(observed_, kLeastTime);
}

}  // namespace fairway
