// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/step_regions.hpp"

#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

// Constrains each step to the rectangle that contains the guess, from rectangle `index` of `size`
// on.
template <typename RectangleAt>
void bind_each(RectangleAt&& rectangle,
               std::size_t index,
               std::size_t size,
               const std::array<Pose2, kMaxHorizon + 1>& poses,
               ControlProblem& problem) noexcept {
  for (int k = 1; k <= problem.horizon; ++k) {
    const auto at = static_cast<std::size_t>(k);
    StepRegion& region = problem.regions[at];
    region.rectangles[0] = rectangle(index);
    region.count = 1;
    const std::size_t next = index + 1;
    if (next < size && rectangle(next).contains(poses[at].position)) {
      region.rectangles[1] = rectangle(next);
      region.count = 2;
      index = next;
    }
  }
}

}  // namespace

void bind_to_current(const CorridorFollower& corridor, ControlProblem& problem) noexcept {
  for (int k = 1; k <= problem.horizon; ++k) {
    StepRegion& region = problem.regions[static_cast<std::size_t>(k)];
    region.rectangles[0] = corridor.admissible(corridor.current());
    region.count = 1;
  }
}

void bind_along(const CorridorFollower& corridor,
                const std::array<Pose2, kMaxHorizon + 1>& poses,
                ControlProblem& problem) noexcept {
  bind_each([&](std::size_t i) { return corridor.admissible(i); }, corridor.current(),
            corridor.size(), poses, problem);
}

PathBands bands_along(const ReferencePath& path, double radius, const BitGrid& obstacles) noexcept {
  PathBands result;
  for (std::size_t i = 1; i < static_cast<std::size_t>(path.count); ++i) {
    if (result.full()) break;
    result.push_back(segment_rectangle(path.points[i - 1], path.points[i]));
    OrientedRectangle& band = result.back();
    for (const double width : {0.5, 0.25, 0.1, 0.05}) {
      const OrientedRectangle wide = band.shrunk(-width);
      if (!is_free(obstacles, wide, radius)) continue;
      band = wide;
      break;
    }
  }
  return result;
}

void bind_along(const PathBands& bands,
                const std::array<Pose2, kMaxHorizon + 1>& poses,
                ControlProblem& problem) noexcept {
  bind_each([&](std::size_t i) { return bands[i]; }, 0, bands.size(), poses, problem);
}

}  // namespace fairway
