// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/navigation/navigation_status.hpp"

namespace fairway {

/// What a person should know about a status or a limiting factor. Names of settings and texts of
/// statuses stand in backticks.
struct StatusGuide {
  const char* meaning = "";  ///< what the robot does, or what holds it back
  const char* causes = "";   ///< why that usually happens
  const char* remedy = "";   ///< what to do about it; empty where nothing is wrong
};

/// The guide of a status: the one place with these texts, for the tool (`fairway statuses`),
/// docs/statuses.md, pages and nodes.
[[nodiscard]] StatusGuide guide_of(NavigationStatus status) noexcept;

/// The guide of a limiting factor.
[[nodiscard]] StatusGuide guide_of(LimitingFactor limit) noexcept;

}  // namespace fairway
