// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/navigation/navigation_status.hpp"

namespace fairway {

/// Explains a status or a limiting factor to users. Names of settings and texts of statuses are in
/// backticks.
struct StatusGuide {
  const char* meaning = "";  ///< what the robot does, or what limits it
  const char* causes = "";   ///< usual causes
  const char* remedy = "";   ///< what to do; empty if nothing is wrong
};

/// Returns the guide of a status. The tool (`fairway statuses`), docs/statuses.md, the pages and
/// the nodes all use these texts.
[[nodiscard]] StatusGuide guide_of(NavigationStatus status) noexcept;

/// Returns the guide of a limiting factor.
[[nodiscard]] StatusGuide guide_of(LimitingFactor limit) noexcept;

}  // namespace fairway
