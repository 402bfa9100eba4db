// SPDX-License-Identifier: Apache-2.0
#include "server/network/origin_check.hpp"

#include <algorithm>

namespace fairway::app {

namespace {

// Returns the host without its port; an IPv6 address keeps its brackets.
std::string_view without_port(std::string_view host) {
  const std::size_t bracket = host.rfind(']');
  const std::size_t colon = host.rfind(':');
  const bool has_port =
      colon != std::string_view::npos && (bracket == std::string_view::npos || colon > bracket);
  return has_port ? host.substr(0, colon) : host;
}

bool is_address(std::string_view host) {
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') return true;
  return !host.empty() && host.find_first_not_of("0123456789.") == std::string_view::npos;
}

bool lists(const std::vector<std::string>& list, std::string_view item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

}  // namespace

bool OriginCheck::allows_host(std::string_view host) const {
  const std::string_view name = without_port(host);
  return name == "localhost" || name == "127.0.0.1" || name == "[::1]" || lists(hosts, name) ||
         (any_address && is_address(name));
}

bool OriginCheck::allows_origin(std::string_view origin, std::string_view host) const {
  if (origin.empty() || lists(origins, origin)) return true;
  constexpr std::string_view kScheme = "http://";
  return origin.starts_with(kScheme) && origin.substr(kScheme.size()) == host;
}

}  // namespace fairway::app
