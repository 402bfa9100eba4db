// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/map/body_clearance.hpp"
#include "fairway/navigation/body/guide/guide.hpp"
#include "fairway/path/se2/body_path_planner.hpp"

namespace fairway {

/// What part of a guide a path is searched along.
struct GuideTask {
  const Guide* guide = nullptr;
  Pose2 start;           ///< where the robot is at rest next
  double arc = 0.0;      ///< of the start on the guide [m]
  double longest = 6.0;  ///< of the guide from there on [m]
  /// Greatest distance from the guide where the robot starts within it [m].
  double bound = 0.5;
  bool may_leave = true;  ///< whether detours may exceed the bound
};

/// A path along a part of a guide, exact, as the base can drive it.
struct GuidePath {
  BodyPathResult result;
  double end = 0.0;       ///< place of the path's end on the guide [m]
  bool complete = false;  ///< the end is the guide's end
  bool within = true;     ///< the whole path keeps the bound
  std::string why;        ///< why there is no path, or no longer one
};

/// Searches a path along a guide, from stop to stop of it. It consists of analytic connections, the
/// longest ones that stay near the guide; where obstacles exclude all of them, of paths of a short
/// search. It ends where the body fits.
[[nodiscard]] GuidePath find_guide_path(const BodyClearance& clearance,
                                        const BaseModel& base,
                                        const GuideTask& task,
                                        const BodyPathSettings& settings);

/// The distance of a body's stop before the end of the longest part that is planned at once [m].
[[nodiscard]] double guide_length_for(const BaseModel& base) noexcept;

}  // namespace fairway
