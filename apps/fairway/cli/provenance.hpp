// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "fairway/map/occupancy_grid.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::app {

/// The inputs of a result.
struct Provenance {
  const char* schema;  ///< "plan.v1": docs/schemas/plan.v1.schema.json describes it
  /// Files and folders of the command line; empty names are left out. Files that these name, such
  /// as maps, are added.
  std::vector<std::string> files;
  const OccupancyGrid* map = nullptr;   ///< if there is one map, as it was understood
  std::optional<std::uint64_t> seed{};  ///< of everything random, if anything is
  const Settings* settings = nullptr;   ///< if the result depends on them
};

/// Adds two fields to a result: `schema`, and `provenance` with the version of the tool, the
/// command line, each input with its size and CRC-32 (of a folder: of all its files, by name), the
/// map's size and the CRC-32 of its cells, the seed, and the settings that are not the defaults.
void add_provenance(Json& result, const Provenance& provenance);

}  // namespace fairway::app
