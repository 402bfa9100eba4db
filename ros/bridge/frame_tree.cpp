// SPDX-License-Identifier: Apache-2.0
#include "bridge/frame_tree.hpp"

#include <algorithm>
#include <limits>

#include "bridge/sensing/pose_history.hpp"

namespace fairway::bridge {

void FrameTree::set(const std::string& parent,
                    const std::string& child,
                    const Pose2& pose,
                    double time) {
  if (is_finite(pose)) links_[child] = {.parent = parent, .pose = pose, .time = time};
}

std::optional<FrameTree::Found> FrameTree::climb(const std::string& frame,
                                                 const std::string& ancestor) const {
  Found found{.pose = {}, .time = std::numeric_limits<double>::infinity()};
  std::string at = frame;
  for (int depth = 0; depth < kDeepest; ++depth) {
    if (at == ancestor) return found;
    const auto link = links_.find(at);
    if (link == links_.end()) return std::nullopt;
    found = {.pose = compose(link->second.pose, found.pose),
             .time = std::min(found.time, link->second.time)};
    at = link->second.parent;
  }
  return std::nullopt;
}

std::optional<FrameTree::Found> FrameTree::find(const std::string& in,
                                                const std::string& of) const {
  std::string meeting = in;
  for (int depth = 0; depth < kDeepest; ++depth) {
    if (const auto below = climb(of, meeting)) {
      const Found above = *climb(in, meeting);
      return Found{.pose = compose(inverse(above.pose), below->pose),
                   .time = std::min(above.time, below->time)};
    }
    const auto link = links_.find(meeting);
    if (link == links_.end()) return std::nullopt;
    meeting = link->second.parent;
  }
  return std::nullopt;
}

}  // namespace fairway::bridge
