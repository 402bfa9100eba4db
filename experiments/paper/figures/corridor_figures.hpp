// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/corridor_study.hpp"

namespace fairway::reproduction {

/// Figures 7 and 8: corridors of four methods along one path.
[[nodiscard]] Figure corridor_figure(const std::string& name,
                                     const std::string& caption,
                                     MapKind kind,
                                     const std::shared_ptr<const CorridorComparison>& map);

/// On an axis-aligned map: SRC, MDSRC and ours.
[[nodiscard]] Figure structured_figure(const std::shared_ptr<const CorridorComparison>& map,
                                       const std::string& caption);

}  // namespace fairway::reproduction
