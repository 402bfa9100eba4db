// SPDX-License-Identifier: Apache-2.0
#include "server/live_server.hpp"

#include <memory>
#include <optional>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include "server/foxglove_dialogue.hpp"
#include "server/live_world.hpp"
#include "server/network/http_session.hpp"
#include "server/page_dialogue.hpp"
#include "server/stop_signal.hpp"
#include "server/uploads/map_uploads.hpp"

namespace fairway::app {

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr int kMostConnections = 32;

class LiveServer {
 public:
  LiveServer(std::vector<MapChoice> maps, OriginCheck check)
      : stop_signal_([this] { loop_.stop(); }),
        acceptor_(loop_),
        pause_(loop_),
        world_(std::move(maps), listener(), LiveWorld::Begin::WithViewer),
        pages_(world_),
        uploads_([this](Scenario scenario) { return world_.use_map(std::move(scenario)); }),
        context_{.world = world_,
                 .uploads = uploads_,
                 .pages = pages_,
                 .viewers = viewers_,
                 .check = std::move(check)} {}

  Expected<void> listen(const ServerSettings& settings) {
    error_code error;
    const auto address = asio::ip::make_address(settings.address, error);
    if (error) return fail("--address: expected an IP address, found '" + settings.address + "'");
    const tcp::endpoint endpoint(address, settings.port);
    acceptor_.open(endpoint.protocol(), error);
    if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (error) {
      return fail("--port: expected a port that is free, found " + std::to_string(settings.port) +
                  ": " + error.message());
    }
    return {};
  }

  [[nodiscard]] std::string url() const {
    const tcp::endpoint endpoint = acceptor_.local_endpoint();
    const std::string host = endpoint.address().is_v6() ? "[" + endpoint.address().to_string() + "]"
                                                        : endpoint.address().to_string();
    return "http://" + host + ":" + std::to_string(endpoint.port()) + "/";
  }

  void run() {
    accept();
    loop_.run();
  }

 private:
  // The world runs in its own thread; its messages are handed over to the network's thread.
  LiveListener listener() {
    const auto handed = [this](auto member) {
      return [this, member](auto what) {
        asio::post(loop_, [this, member, what = std::move(what)]() mutable {
          (pages_.*member)(std::move(what));
        });
      };
    };
    return {.on_run = handed(&PageDialogue::run),
            .on_records = handed(&PageDialogue::records),
            .on_beginning = handed(&PageDialogue::beginning),
            .on_messages =
                [this](LiveMessages::Batch batch) {
                  asio::post(loop_, [this, batch = std::move(batch)]() mutable {
                    viewers_.publish(std::move(batch));
                  });
                },
            .on_state = handed(&PageDialogue::state),
            .on_notice = handed(&PageDialogue::notice),
            .on_refusal = handed(&PageDialogue::refusal)};
  }

  void accept() {
    acceptor_.async_accept([this](error_code error, tcp::socket socket) {
      if (error) {
        // Most likely there are no free descriptors. Try again when some are free.
        pause_.expires_after(std::chrono::milliseconds(200));
        pause_.async_wait([this](error_code) { accept(); });
        return;
      }
      if (connections_ < kMostConnections) {
        ++connections_;
        error_code ignored;
        socket.set_option(tcp::no_delay(true), ignored);
        start_http_session(std::move(socket), context_, [this] { --connections_; });
      }
      accept();
    });
  }

  // Handlers that remain in the loop when it is destroyed hold sessions, which use the members
  // below. So the world's thread must end first, and the loop must be emptied before the rest is
  // destroyed.
  int connections_ = 0;
  FoxgloveDialogue viewers_;
  asio::io_context loop_{1};
  StopSignal stop_signal_;  // before all other threads
  tcp::acceptor acceptor_;
  asio::steady_timer pause_;
  LiveWorld world_;
  PageDialogue pages_;
  MapUploads uploads_;
  HttpContext context_;
};

}  // namespace

Expected<void> serve_live(std::vector<MapChoice> maps,
                          const ServerSettings& settings,
                          const std::function<void(const std::string&)>& on_ready) {
  LiveServer server(std::move(maps), settings.check);
  if (auto listening = server.listen(settings); !listening) return listening;
  on_ready(server.url());
  server.run();
  return {};
}

}  // namespace fairway::app
