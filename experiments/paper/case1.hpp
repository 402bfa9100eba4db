// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/studies/study_options.hpp"

namespace fairway::reproduction {

/// Case 1, driving, compares ISMPC with SMPC and with the defaults of Fairway. It draws Figures 5
/// and 6, and shows where dual targets leave the robot stuck. `options.maps` is the number of maps
/// per course.
[[nodiscard]] Chapter run_case1(const StudyOptions& options);

}  // namespace fairway::reproduction
