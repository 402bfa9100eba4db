// SPDX-License-Identifier: Apache-2.0
#include "fairway/localization/shift_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace fairway {

std::optional<double> find_shift(const SurfacePoints& map,
                                 std::span<const SurfacePoint> scan,
                                 const Eigen::Vector2d& center,
                                 const ScanMotion& motion,
                                 const Eigen::Vector2d& along,
                                 double reach) noexcept {
  constexpr double kFaces = 0.8;  // cosine of the angle between normal and direction
  constexpr double kStep = 0.05;  // [m]
  constexpr int kMostSteps = 40;
  constexpr double kNear = 0.05;       // [m]; of a point on the map
  constexpr int kFewest = 8;           // points
  constexpr double kLeastShare = 0.6;  // of these points
  constexpr double kClearly = 1.5;     // times as many as with any shift that is far from it
  constexpr int kNeighbours = 3;       // [steps]; shifts that near are no others
  const MotionAbout move(center, motion);
  int facing = 0;
  for (const SurfacePoint& point : scan) {
    if (std::abs(move.turned(point.normal).dot(along)) > kFaces) ++facing;
  }
  if (facing < kFewest) return std::nullopt;
  const auto count_at = [&](double shift) {
    int fit = 0;
    for (const SurfacePoint& point : scan) {
      const Eigen::Vector2d normal = move.turned(point.normal);
      if (std::abs(normal.dot(along)) <= kFaces) continue;
      const SurfacePoint now{.position = move(point.position) + shift * along, .normal = normal};
      if (map.nearest(now, kNear) != nullptr) ++fit;
    }
    return fit;
  };
  const int steps = std::min(kMostSteps, static_cast<int>(std::ceil(reach / kStep)));
  std::array<int, 2 * kMostSteps + 1> counts{};
  int most = 0;
  int best = 0;  // [steps]
  for (int i = -steps; i <= steps; ++i) {
    const int fit = count_at(i * kStep);
    counts[static_cast<std::size_t>(i + steps)] = fit;
    if (fit < most || (fit == most && std::abs(i) >= std::abs(best))) continue;
    most = fit;
    best = i;
  }
  if (most < kLeastShare * facing) return std::nullopt;
  for (int i = -steps; i <= steps; ++i) {
    const bool other = std::abs(i - best) > kNeighbours;
    if (other && kClearly * counts[static_cast<std::size_t>(i + steps)] > most) return std::nullopt;
  }
  return best * kStep;
}

}  // namespace fairway
