// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

namespace fairway::vda5050 {

/// Serves the live page on this machine: the page, the map, and the newest snapshot of the robots,
/// which the page asks for. A thread answers one request after another.
class PageServer {
 public:
  /// @param map  The JSON that /map returns.
  /// @throws std::runtime_error if the port cannot be opened.
  PageServer(int port, std::string map);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// Replaces the JSON that /robots returns.
  void show(std::string robots);

  /// The port in use; the given one, or a free one for 0.
  [[nodiscard]] int port() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the answer to a request of HTTP; for tests too. A request from another site, or for
/// anything but the page and its data, is refused.
[[nodiscard]] std::string answer_to(const std::string& request,
                                    const std::string& map,
                                    const std::string& robots);

}  // namespace fairway::vda5050
