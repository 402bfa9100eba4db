// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/navigation/navigation_status.hpp"

namespace fairway {

/// Returns the short name of a status for people, such as "Driving (limited)". Files and messages
/// for programs have `to_text`.
[[nodiscard]] const char* label_of(NavigationStatus status) noexcept;

/// Returns the short name of a limiting factor for people.
[[nodiscard]] const char* label_of(LimitingFactor limit) noexcept;

}  // namespace fairway
