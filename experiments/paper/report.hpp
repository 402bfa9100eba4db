// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/paper/chapter.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::reproduction {

/// What a report says about itself.
struct ReportInfo {
  Settings settings;    ///< of the runs called "ours"
  std::string command;  ///< that makes it again
  std::string version;  ///< of Fairway
  std::string solver;
  std::uint64_t seed = 0;
};

/// Writes results.json, index.html, timing.html and figures/NAME.svg, .png and .pdf into `folder`,
/// which is made. Each file is written whole or not at all, the figures first. Fails before any
/// work if the folder cannot be made.
[[nodiscard]] Expected<void> write_report(const std::string& folder,
                                          const std::vector<Chapter>& chapters,
                                          const ReportInfo& info);

/// Makes the folders of a report, for work that should not fail at its very end.
[[nodiscard]] Expected<void> make_report_folder(const std::string& folder);

/// The findings and where to look, for a person at a terminal.
[[nodiscard]] std::string report_summary(const std::string& folder,
                                         const std::vector<Chapter>& chapters);

}  // namespace fairway::reproduction
