// SPDX-License-Identifier: Apache-2.0
#include "server/network/socket_session.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <functional>
#include <utility>

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>

#include "experiments/clocks.hpp"

namespace fairway::app {

namespace {

namespace beast = boost::beast;
namespace websocket = beast::websocket;
using beast::error_code;

constexpr std::size_t kLargestMessage = 64U << 10U;    // that a client may send [bytes]
constexpr std::size_t kMostWaitingBytes = 48U << 20U;  // to be sent to a client [bytes]
constexpr double kMessagesPerSecond = 200.0;           // beyond that a client is read more slowly
constexpr double kBurst = 400.0;                       // messages at once

class SocketSession final : public Connection, public std::enable_shared_from_this<SocketSession> {
 public:
  SocketSession(beast::tcp_stream stream, Dialogue& dialogue, std::function<void()> on_end)
      : socket_(std::move(stream)),
        timer_(socket_.get_executor()),
        dialogue_(dialogue),
        on_end_(std::move(on_end)) {}

  ~SocketSession() override { on_end_(); }

  void accept(const HttpRequest& request, const char* protocol) {
    beast::get_lowest_layer(socket_).expires_never();
    auto timeout = websocket::stream_base::timeout::suggested(beast::role_type::server);
    timeout.idle_timeout = std::chrono::seconds(60);  // of one that does not answer pings either
    timeout.keep_alive_pings = true;
    socket_.set_option(timeout);
    socket_.read_message_max(kLargestMessage);
    socket_.set_option(websocket::stream_base::decorator([protocol](auto& response) {
      if (protocol != nullptr) {
        response.set(beast::http::field::sec_websocket_protocol, protocol);
      }
    }));
    socket_.async_accept(request, [self = shared_from_this()](error_code error) {
      if (error) return;
      self->open_ = true;
      self->dialogue_.on_open(*self);
      self->read();
    });
  }

  void send(std::shared_ptr<const std::string> message, bool binary) override {
    if (!open_) return;
    waiting_ += message->size();
    queue_.push_back({.content = std::move(message), .binary = binary});
    if (waiting_ > kMostWaitingBytes) {
      // The client does not keep up. The pending read ends, and with it the session.
      beast::get_lowest_layer(socket_).cancel();
      return;
    }
    if (queue_.size() == 1) write();
  }

 private:
  struct Outgoing {
    std::shared_ptr<const std::string> content;
    bool binary;
  };

  void read() {
    socket_.async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
      // A write may have failed after this message was received.
      if (error || !self->open_) return self->end();
      const auto bytes = self->buffer_.cdata();
      self->dialogue_.on_message(*self, {static_cast<const char*>(bytes.data()), bytes.size()},
                                 self->socket_.got_binary());
      self->buffer_.consume(self->buffer_.size());
      self->pace();
    });
  }

  // A client that sends too much is read no faster than this; the rest waits at the sender.
  void pace() {
    const double now = steady_seconds();
    allowance_ = std::min(kBurst, allowance_ + (now - last_read_) * kMessagesPerSecond) - 1.0;
    last_read_ = now;
    if (allowance_ >= 0.0) return read();
    timer_.expires_after(std::chrono::milliseconds(50));
    timer_.async_wait([self = shared_from_this()](error_code error) {
      if (error || !self->open_) return self->end();
      self->read();
    });
  }

  void write() {
    const Outgoing& next = queue_.front();
    socket_.binary(next.binary);
    socket_.async_write(boost::asio::buffer(*next.content),
                        [self = shared_from_this()](error_code error, std::size_t) {
                          if (error) return self->end();
                          self->waiting_ -= self->queue_.front().content->size();
                          self->queue_.pop_front();
                          if (!self->queue_.empty()) self->write();
                        });
  }

  void end() {
    if (!std::exchange(open_, false)) return;
    dialogue_.on_closed(*this);
    timer_.cancel();
    beast::get_lowest_layer(socket_).close();
  }

  websocket::stream<beast::tcp_stream> socket_;
  boost::asio::steady_timer timer_;
  Dialogue& dialogue_;
  std::function<void()> on_end_;
  beast::flat_buffer buffer_;
  std::deque<Outgoing> queue_;
  std::size_t waiting_ = 0;
  bool open_ = false;
  double allowance_ = kBurst;
  double last_read_ = steady_seconds();
};

}  // namespace

void start_socket_session(beast::tcp_stream stream,
                          const HttpRequest& request,
                          Dialogue& dialogue,
                          const char* protocol,
                          std::function<void()> on_end) {
  std::make_shared<SocketSession>(std::move(stream), dialogue, std::move(on_end))
      ->accept(request, protocol);
}

}  // namespace fairway::app
