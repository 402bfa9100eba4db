// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include "page/live_page.hpp"
#include "page/page_server.hpp"

namespace fairway::vda5050 {

namespace {

std::string response(const char* status, const char* type, std::string_view body) {
  return std::string("HTTP/1.1 ") + status + "\r\nContent-Type: " + type +
         "\r\nContent-Length: " + std::to_string(body.size()) +
         "\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nConnection: "
         "close\r\n\r\n" +
         std::string(body);
}

// A page of another site that has this address under a name of its own must not read the robots.
bool is_local(std::string_view request) {
  const std::size_t at = request.find("\r\nHost: ");
  if (at == std::string_view::npos) return false;
  const std::string_view host = request.substr(at + 8, request.find("\r\n", at + 2) - at - 8);
  const std::string_view name = host.substr(0, host.find(':'));
  return name == "127.0.0.1" || name == "localhost";
}

}  // namespace

std::string answer_to(const std::string& request,
                      const std::string& map,
                      const std::string& robots) {
  if (!is_local(request))
    return response("403 Forbidden", "text/plain", "only from this machine\n");
  const auto asks = [&](const char* path) {
    return request.rfind("GET " + std::string(path) + " HTTP/1.", 0) == 0;
  };
  if (asks("/")) return response("200 OK", "text/html; charset=utf-8", kLivePage);
  if (asks("/map")) return response("200 OK", "application/json", map);
  if (asks("/robots")) return response("200 OK", "application/json", robots);
  return response("404 Not Found", "text/plain", "expected /, /map or /robots\n");
}

}  // namespace fairway::vda5050
