// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace fairway::io {

/// The page that viewer/ builds: with a run in it the replay page, served as it is the live page.
[[nodiscard]] std::string_view viewer_page() noexcept;

}  // namespace fairway::io
