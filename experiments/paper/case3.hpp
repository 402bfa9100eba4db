// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/study_options.hpp"

namespace fairway::reproduction {

/// Case 3, four robots that exchange places: Figure 11 and separation over time. `options.maps` is
/// the number of runs.
[[nodiscard]] Chapter run_case3(const StudyOptions& options);

}  // namespace fairway::reproduction
