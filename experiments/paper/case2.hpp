// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/study_options.hpp"

namespace fairway::reproduction {

/// Case 2, the corridors: Table II, Figures 7 to 10, and where the paper's claims about corridors
/// do not hold. `options.maps` is the number of maps per environment; there are five times as many
/// fields.
[[nodiscard]] Chapter run_case2(const StudyOptions& options);

}  // namespace fairway::reproduction
