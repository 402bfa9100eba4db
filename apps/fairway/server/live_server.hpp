// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fairway/base/error.hpp"
#include "server/live_maps.hpp"
#include "server/network/origin_check.hpp"

namespace fairway::app {

/// Address at which the live page is served, and names by which it may be addressed.
struct ServerSettings {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8787;  ///< 0: one that is free
  OriginCheck check;
};

/// Serves a live world until the process receives SIGINT or SIGTERM.
/// @param on_ready  Called with the address of the page, once it can be opened.
[[nodiscard]] Expected<void> serve_live(std::vector<MapChoice> maps,
                                        const ServerSettings& settings,
                                        const std::function<void(const std::string&)>& on_ready);

}  // namespace fairway::app
