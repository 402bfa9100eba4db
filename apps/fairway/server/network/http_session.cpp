// SPDX-License-Identifier: Apache-2.0
#include "server/network/http_session.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include <boost/asio/post.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "fairway/io/web_report/viewer_page.hpp"
#include "server/network/socket_session.hpp"

namespace fairway::app {

namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using beast::error_code;

constexpr std::uint32_t kLargestHeader = 8U << 10U;  // [bytes]
constexpr std::uint64_t kLargestUpload = 24U << 20U;
constexpr int kMostDownloadsAtOnce = 4;  // at once
constexpr auto kPatience = std::chrono::seconds(30);

using Response = http::response<http::string_body>;

class HttpSession final : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(boost::asio::ip::tcp::socket socket,
              HttpContext& context,
              std::function<void()> on_end)
      : stream_(std::move(socket)),
        context_(context),
        on_end_(std::move(on_end)) {}

  ~HttpSession() {
    end_download();
    if (on_end_) on_end_();
  }
  HttpSession(const HttpSession&) = delete;
  HttpSession& operator=(const HttpSession&) = delete;

  void read() {
    parser_.emplace();
    parser_->header_limit(kLargestHeader);
    parser_->body_limit(kLargestUpload);
    stream_.expires_after(kPatience);
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = shared_from_this()](error_code error, std::size_t) {
                              if (!error) self->on_header();
                            });
  }

 private:
  // Requests that are not allowed, or ask for unknown targets, are answered before a body is read.
  void on_header() {
    const auto& request = parser_->get();
    const std::string_view host = view(request[http::field::host]);
    const std::string_view origin = view(request[http::field::origin]);
    if (!context_.check.allows_host(host)) return refuse(http::status::misdirected_request);
    const bool upgrade = beast::websocket::is_upgrade(request);
    if (upgrade || request.method() == http::verb::post) {
      if (!context_.check.allows_origin(origin, host)) return refuse(http::status::forbidden);
    }
    if (upgrade) return open_socket();
    if (request.method() == http::verb::post) {
      if (view(request.target()) != "/map") return refuse(http::status::not_found);
      http::async_read(stream_, buffer_, *parser_,
                       [self = shared_from_this()](error_code error, std::size_t) {
                         if (error == http::error::body_limit) {
                           return self->refuse(http::status::payload_too_large);
                         }
                         if (!error) self->take_map();
                       });
      return;
    }
    if (request.method() != http::verb::get) return refuse(http::status::method_not_allowed);
    if (!parser_->is_done()) return refuse(http::status::bad_request);  // a GET with a body
    get(view(request.target()));
  }

  void get(std::string_view target) {
    using Download = LiveWorld::Download;
    if (target == "/") return answer(http::status::ok, "text/html; charset=utf-8", page());
    if (target == "/recording.mcap") return save(Download::Recording, "run.mcap");
    if (target == "/scenario.zip") return save(Download::Scenario, "scenario.zip");
    if (target == "/report.html") return save(Download::Report, "run.html");
    refuse(http::status::not_found);
  }

  static std::string page() { return std::string(io::viewer_page()); }

  void end_download() {
    if (std::exchange(downloading_, false)) --context_.downloads;
  }

  void save(LiveWorld::Download what, const char* name) {
    if (context_.downloads >= kMostDownloadsAtOnce)
      return refuse(http::status::service_unavailable);
    ++context_.downloads;
    downloading_ = true;
    stream_.expires_never();  // the world answers when it is between two cycles
    const auto executor = stream_.get_executor();
    // The world's thread hands the session back, because it must be destroyed in the network's
    // thread.
    const auto done = [self = shared_from_this(), executor, name](std::string bytes) mutable {
      boost::asio::post(
          executor, [self = std::move(self), name, bytes = std::move(bytes)]() mutable {
            self->stream_.expires_after(10 * kPatience);
            self->answer(http::status::ok, "application/octet-stream", std::move(bytes), name);
          });
    };
    context_.world.download(what, done);
  }

  void take_map() {
    const std::string_view type = view(parser_->get()[http::field::content_type]);
    // A page of any site could send other content types without a preflight request.
    if (type != "application/json") return refuse(http::status::unsupported_media_type);
    stream_.expires_never();  // decoding has bounds of its own
    const auto executor = stream_.get_executor();
    // The thread hands the session back, because it must be destroyed in the network's thread.
    const auto done = [self = shared_from_this(), executor](MapUploads::Outcome outcome,
                                                            std::string reason) mutable {
      boost::asio::post(executor,
                        [self = std::move(self), outcome, reason = std::move(reason)]() mutable {
                          self->stream_.expires_after(kPatience);
                          self->answer_upload(outcome, std::move(reason));
                        });
    };
    if (!context_.uploads.add(std::move(parser_->get().body()), done))
      refuse(http::status::service_unavailable);
  }

  void answer_upload(MapUploads::Outcome outcome, std::string reason) {
    if (outcome == MapUploads::Outcome::Busy) return refuse(http::status::service_unavailable);
    answer(outcome == MapUploads::Outcome::Used ? http::status::ok
                                                : http::status::unprocessable_entity,
           "text/plain; charset=utf-8", std::move(reason));
  }

  void open_socket() {
    const auto& request = parser_->get();
    const std::string_view offered = view(request[http::field::sec_websocket_protocol]);
    const bool is_viewer = offered.find(FoxgloveDialogue::kProtocol) != std::string_view::npos;
    if (!is_viewer && view(request.target()) != "/live") return refuse(http::status::not_found);
    context_.world.welcome();
    Dialogue& dialogue = is_viewer ? static_cast<Dialogue&>(context_.viewers) : context_.pages;
    // The socket session now owns the connection, and reports its end.
    start_socket_session(std::move(stream_), parser_->release(), dialogue,
                         is_viewer ? FoxgloveDialogue::kProtocol : nullptr,
                         std::exchange(on_end_, nullptr));
  }

  void refuse(http::status status) {
    answer(status, "text/plain; charset=utf-8", std::string(http::obsolete_reason(status)) + "\n",
           nullptr, true);
  }

  void answer(http::status status,
              const char* type,
              std::string body,
              const char* file_name = nullptr,
              bool close = false) {
    response_ = Response(status, 11);
    response_.set(http::field::content_type, type);
    response_.set(http::field::cache_control, "no-store");
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("Referrer-Policy", "no-referrer");
    response_.set("X-Frame-Options", "DENY");
    response_.set("Content-Security-Policy",
                  "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
                  "img-src data: blob:; connect-src 'self' ws:; frame-ancestors 'none'");
    if (file_name != nullptr) {
      response_.set(http::field::content_disposition,
                    std::string("attachment; filename=\"") + file_name + "\"");
    }
    response_.body() = std::move(body);
    response_.keep_alive(!close && parser_->get().keep_alive());
    response_.prepare_payload();
    http::async_write(
        stream_, response_, [self = shared_from_this()](error_code error, std::size_t) {
          self->response_.body().clear();
          self->response_.body().shrink_to_fit();
          self->end_download();
          if (error) return;
          if (self->response_.keep_alive()) return self->read();
          error_code ignored;
          self->stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
        });
  }

  template <typename Text>
  static std::string_view view(const Text& text) {
    return {text.data(), text.size()};
  }

  beast::tcp_stream stream_;
  HttpContext& context_;
  std::function<void()> on_end_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  Response response_;
  bool downloading_ = false;
};

}  // namespace

void start_http_session(boost::asio::ip::tcp::socket socket,
                        HttpContext& context,
                        std::function<void()> on_end) {
  std::make_shared<HttpSession>(std::move(socket), context, std::move(on_end))->read();
}

}  // namespace fairway::app
