// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/corridor_study.hpp"

namespace fairway::reproduction {

/// A published rectangle that contains obstacles, with a close-up; none when no map has one.
[[nodiscard]] std::optional<Figure> hopping_figure(MapKind kind,
                                                   const std::vector<CorridorComparison>& maps);

/// Published neighbours that overlap only before contraction, with a close-up; none when no map has
/// such a pair.
[[nodiscard]] std::optional<Figure> break_figure(MapKind kind,
                                                 const std::vector<CorridorComparison>& maps);

}  // namespace fairway::reproduction
