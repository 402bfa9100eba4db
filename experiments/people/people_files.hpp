// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/people/crowd.hpp"
#include "experiments/people/recorded.hpp"
#include "fairway/base/error.hpp"

namespace fairway::io {

/// Reads the tasks of `cases.csv` in a folder, in the order of the file. `numbers` selects cases;
/// empty: all. Every number must be there.
[[nodiscard]] Expected<std::vector<RecordedCase>> read_recorded_cases(
    const std::string& folder, const std::vector<int>& numbers);

/// Reads `tracks_SCENE.csv` of a folder, with the scene's name in lower case.
[[nodiscard]] Expected<PeopleRecording> read_recording(const std::string& folder,
                                                       const std::string& scene);

/// Reads the starts of a benchmark's cases, `crowdnav_cases.csv` and others, of a folder.
[[nodiscard]] Expected<std::vector<CrowdCase>> read_crowd_cases(const std::string& folder,
                                                                CrowdBenchmark benchmark,
                                                                const std::vector<int>& numbers);

}  // namespace fairway::io
