// SPDX-License-Identifier: Apache-2.0
#include "server/network/socket_session.hpp"

#include <set>
#include <string>
#include <thread>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <gtest/gtest.h>

namespace fairway::app {
namespace {

namespace beast = boost::beast;
using boost::asio::ip::tcp;

// Answers each message with more than the client will read, and remembers who is connected.
class AnsweringDialogue final : public Dialogue {
 public:
  void on_open(Connection& connection) override { open_.insert(&connection); }
  void on_message(Connection& connection, std::string_view, bool) override {
    ++messages;
    if (!open_.contains(&connection)) ++after_the_end;
    connection.send(answer_, true);
  }
  void on_closed(Connection& connection) override { open_.erase(&connection); }

  int messages = 0;
  int after_the_end = 0;

 private:
  std::set<Connection*> open_;
  std::shared_ptr<const std::string> answer_ = shared(std::string(1U << 20U, 'x'));
};

// A masked text frame with an empty message.
std::string empty_frame() { return {'\x81', '\x80', 0, 0, 0, 0}; }

// A client that asks for a WebSocket, sends many messages at once and resets the connection.
void send_and_reset(const tcp::endpoint& server, int messages) {
  boost::asio::io_context loop;
  tcp::socket socket(loop);
  socket.connect(server);
  const std::string handshake =
      "GET / HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
  boost::asio::write(socket, boost::asio::buffer(handshake));
  char answer[16];
  static_cast<void>(socket.read_some(boost::asio::buffer(answer)));
  std::string frames;
  for (int i = 0; i < messages; ++i)
    frames += empty_frame();
  boost::asio::write(socket, boost::asio::buffer(frames));
  socket.set_option(boost::asio::socket_base::linger(true, 0));
  socket.close();
}

// A write may fail while messages that were received before still wait to be handled.
TEST(SocketSession, HandsNoMessageOverAfterTheEnd) {
  boost::asio::io_context loop;
  tcp::acceptor acceptor(loop, {boost::asio::ip::make_address("127.0.0.1"), 0});
  AnsweringDialogue dialogue;
  constexpr int kClients = 60;
  std::thread clients([&, endpoint = acceptor.local_endpoint()] {
    for (int i = 0; i < kClients; ++i)
      send_and_reset(endpoint, 20 + 10 * i);
  });
  int ended = 0;
  for (int i = 0; i < kClients; ++i) {
    beast::tcp_stream stream(acceptor.accept());
    beast::flat_buffer buffer;
    HttpRequest request;
    beast::http::read(stream, buffer, request);
    start_socket_session(std::move(stream), request, dialogue, nullptr, [&] { ++ended; });
    loop.restart();
    loop.run();
  }
  clients.join();
  EXPECT_EQ(ended, kClients);
  EXPECT_GT(dialogue.messages, 0);
  EXPECT_EQ(dialogue.after_the_end, 0);
}

}  // namespace
}  // namespace fairway::app
