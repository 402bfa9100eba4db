// SPDX-License-Identifier: Apache-2.0
#include "page/page_server.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

namespace fairway::vda5050 {

namespace {

constexpr std::size_t kLongestRequest = 8192;  // [bytes]

// Waits until a socket can be read. @return whether it can.
bool readable(int socket, int milliseconds) {
  pollfd watched{.fd = socket, .events = POLLIN, .revents = 0};
  return poll(&watched, 1, milliseconds) > 0;
}

std::string read_request(int client) {
  std::string request;
  std::array<char, 2048> part{};
  constexpr int kPatience = 1000;  // [ms]
  while (request.size() < kLongestRequest && request.find("\r\n\r\n") == std::string::npos) {
    if (!readable(client, kPatience)) break;
    const ssize_t count = recv(client, part.data(), part.size(), 0);
    if (count <= 0) break;
    request.append(part.data(), static_cast<std::size_t>(count));
  }
  return request;
}

void send_all(int client, const std::string& text) {
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t count = send(client, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

}  // namespace

struct PageServer::State {
  int socket = -1;
  int port = 0;
  std::string map;
  std::mutex mutex;
  std::string robots = "{}";
  std::atomic<bool> ends{false};
  std::thread thread;

  void serve() {
    constexpr int kPeriod = 100;  // [ms], until the end is noticed
    while (!ends) {
      if (!readable(socket, kPeriod)) continue;
      const int client = accept(socket, nullptr, nullptr);
      if (client < 0) continue;
      const timeval patience{.tv_sec = 1, .tv_usec = 0};
      setsockopt(client, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof(patience));
      const std::string request = read_request(client);
      std::string now;
      {
        const std::lock_guard lock(mutex);
        now = robots;
      }
      send_all(client, answer_to(request, map, now));
      close(client);
    }
  }
};

PageServer::PageServer(int port, std::string map) : state_(std::make_unique<State>()) {
  state_->map = std::move(map);
  state_->socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int yes = 1;
  setsockopt(state_->socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* const general = reinterpret_cast<sockaddr*>(&address);
  socklen_t length = sizeof(address);
  if (state_->socket < 0 || bind(state_->socket, general, length) != 0 ||
      listen(state_->socket, 16) != 0 || getsockname(state_->socket, general, &length) != 0) {
    if (state_->socket >= 0) close(state_->socket);
    throw std::runtime_error("--page: expected a free port, found " + std::to_string(port) +
                             ", which cannot be opened");
  }
  state_->port = ntohs(address.sin_port);
  state_->thread = std::thread([state = state_.get()] { state->serve(); });
}

PageServer::~PageServer() {
  state_->ends = true;
  state_->thread.join();
  close(state_->socket);
}

void PageServer::show(std::string robots) {
  const std::lock_guard lock(state_->mutex);
  state_->robots = std::move(robots);
}

int PageServer::port() const noexcept { return state_->port; }

}  // namespace fairway::vda5050
