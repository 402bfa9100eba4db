// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "fairway/zones/zones.hpp"

namespace fairway::io::exact {

/// Zones as JSON, as exact_json.hpp says.
[[nodiscard]] nlohmann::json to_json(const Zones& zones);

/// The keys and values of a zone as a scenario file has them, in one line.
[[nodiscard]] std::string zone_fields(const Zone& zone);

/// @throws std::invalid_argument unless the zones are valid.
[[nodiscard]] Zones to_zones(const nlohmann::json& json);

}  // namespace fairway::io::exact
