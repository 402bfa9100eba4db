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

/// The files of a scenario: scenario.yaml, map.yaml and map.pgm. `read_scenario` gives the same
/// scenario after they are unpacked into one folder.
[[nodiscard]] std::vector<ArchiveFile> scenario_files(const Scenario& scenario);

/// Packs files into a ZIP archive without compression. Equal files give equal bytes.
/// @pre the names are ASCII; the total size is below 4 GB.
[[nodiscard]] std::string zip_archive(const std::vector<ArchiveFile>& files);

}  // namespace fairway::io
