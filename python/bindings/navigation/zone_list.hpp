// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bindings.hpp"
#include "fairway/zones/zones.hpp"

namespace fairway::python {

/// Reads a list of mappings with the keys of a zone in a scenario file.
/// @throws std::invalid_argument that names the zone and the key.
[[nodiscard]] Zones zones_of(const py::sequence& list);

}  // namespace fairway::python
