// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

#include "server/connection.hpp"

namespace fairway::app {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;

/// Accepts a WebSocket upgrade and connects it with a dialogue, which must outlive the network's
/// loop.
/// @param protocol  The subprotocol to agree on; null for none.
/// @param on_end    Called once when the connection is over.
void start_socket_session(boost::beast::tcp_stream stream,
                          const HttpRequest& request,
                          Dialogue& dialogue,
                          const char* protocol,
                          std::function<void()> on_end);

}  // namespace fairway::app
