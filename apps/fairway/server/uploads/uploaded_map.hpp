// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "fairway/base/error.hpp"
#include "fairway/map/occupancy_grid.hpp"

namespace fairway::app {

/// A map that a client uploaded.
struct UploadedMap {
  std::string name;
  OccupancyGrid map;
};

/// Reads an uploaded map from JSON. The object has `name`, `image` (a PGM or PNG as base64) and
/// either `yaml` (the text of its map_server file) or `resolution` [m]. Both files are read as
/// `fairway::io` reads maps; the image that the YAML names is ignored. Maps beyond 16 million cells
/// are refused.
[[nodiscard]] Expected<UploadedMap> read_uploaded_map(std::string_view json);

}  // namespace fairway::app
