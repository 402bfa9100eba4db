// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fairway::io {

/// Bytes as base64 (RFC 4648, with padding).
[[nodiscard]] std::string to_base64(std::string_view bytes);

/// The bytes; none where `text` is not base64 with padding.
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);

}  // namespace fairway::io
