// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/paper/chapter.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::reproduction {

/// How a report was made.
struct ReportInfo {
  Settings settings;    ///< of the runs called "ours"
  std::string command;  ///< that reproduces it
  std::string version;  ///< of Fairway
  std::string solver;
  std::uint64_t seed = 0;
};

/// Writes results.json, index.html, CASE.html, timing.html and figures/NAME.svg, .png and .pdf into
/// `folder`, which is created. Each file is written completely or not at all, the figures first.
/// Fails before any work if the folder cannot be created.
[[nodiscard]] Expected<void> write_report(const std::string& folder,
                                          const std::vector<Chapter>& chapters,
                                          const ReportInfo& info);

/// Creates the folders of a report, so that long work does not fail at its end.
[[nodiscard]] Expected<void> make_report_folder(const std::string& folder);

/// The findings and the paths of the files, for a terminal.
[[nodiscard]] std::string report_summary(const std::string& folder,
                                         const std::vector<Chapter>& chapters);

}  // namespace fairway::reproduction
