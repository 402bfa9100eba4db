// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include <boost/asio/ip/tcp.hpp>

#include "server/foxglove_dialogue.hpp"
#include "server/live_world.hpp"
#include "server/network/origin_check.hpp"
#include "server/page_dialogue.hpp"
#include "server/uploads/map_uploads.hpp"

namespace fairway::app {

/// The state from which requests are answered. Exists as long as the network's loop.
struct HttpContext {
  LiveWorld& world;
  MapUploads& uploads;
  PageDialogue& pages;
  FoxgloveDialogue& viewers;
  OriginCheck check;
  int downloads = 0;  ///< that are being answered
};

/// Answers the requests of one connection, one after another:
///
///     GET /                                            the page
///     GET /recording.mcap /scenario.zip /report.html   files that the world makes
///     POST /map                                        a map: {name, yaml, resolution, image}
///     WebSocket /live                                  the page's dialogue
///     WebSocket with foxglove.websocket.v1             viewers
///
/// An image is base64. To bound memory, only few downloads are answered at the same time. No part
/// of a request is ever used as a file name.
/// @param on_end  Called once when the connection is over.
void start_http_session(boost::asio::ip::tcp::socket socket,
                        HttpContext& context,
                        std::function<void()> on_end);

}  // namespace fairway::app
