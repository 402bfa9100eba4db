// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fairway::app {

/// Decides which requests a server on this machine answers. A page of any site can make a browser
/// connect to it. So requests must name a host that can only be this server (against names that are
/// made to resolve here), and requests that change the world must come from a page of its own.
struct OriginCheck {
  std::vector<std::string> hosts;    ///< further host names by which it may be addressed
  std::vector<std::string> origins;  ///< further origins whose pages may connect
  bool any_address = false;          ///< whether it may be addressed by any IP address

  /// @param host  The Host header, with or without port.
  [[nodiscard]] bool allows_host(std::string_view host) const;

  /// @param origin  The Origin header; empty when there is none, as from programs: allowed.
  [[nodiscard]] bool allows_origin(std::string_view origin, std::string_view host) const;
};

}  // namespace fairway::app
