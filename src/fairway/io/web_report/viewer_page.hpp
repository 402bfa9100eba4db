// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace fairway::io {

/// The page built from viewer/: the replay page with a run inserted, the live page without one.
[[nodiscard]] std::string_view viewer_page() noexcept;

}  // namespace fairway::io
