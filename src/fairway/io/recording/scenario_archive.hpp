// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fairway/simulation/scenario.hpp"

namespace fairway::io {

/// A file of an archive.
struct ArchiveFile {
  std::string name;
  std::string content;
};

/// The files of a scenario: scenario.yaml, map.yaml and map.pgm. Unpacked into one folder,
/// `read_scenario` gives the same scenario back.
[[nodiscard]] std::vector<ArchiveFile> scenario_files(const Scenario& scenario);

/// Files as a ZIP archive, stored without compression. The same files give the same bytes.
/// @pre the names are ASCII; everything together is below 4 GB.
[[nodiscard]] std::string zip_archive(const std::vector<ArchiveFile>& files);

}  // namespace fairway::io
