// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/step_regions.hpp"

namespace fairway {

void bind_to_nothing(ControlProblem& problem) noexcept {
  for (int k = 1; k <= problem.horizon; ++k)
    problem.regions[static_cast<std::size_t>(k)].count = 0;
}

void bind_to_current(const CorridorString& corridor, ControlProblem& problem) noexcept {
  for (int k = 1; k <= problem.horizon; ++k) {
    StepRegion& region = problem.regions[static_cast<std::size_t>(k)];
    region.rectangles[0] = corridor.admissible(corridor.current());
    region.count = 1;
  }
}

void bind_along(const CorridorString& corridor,
                const std::array<Pose2, kMaxHorizon + 1>& poses,
                ControlProblem& problem) noexcept {
  std::size_t index = corridor.current();
  for (int k = 1; k <= problem.horizon; ++k) {
    const auto at = static_cast<std::size_t>(k);
    StepRegion& region = problem.regions[at];
    region.rectangles[0] = corridor.admissible(index);
    region.count = 1;
    const std::size_t next = index + 1;
    if (next < corridor.size() && corridor.admissible(next).contains(poses[at].position)) {
      region.rectangles[1] = corridor.admissible(next);
      region.count = 2;
      index = next;
    }
  }
}

}  // namespace fairway
