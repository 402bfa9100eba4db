// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/figures/drive_style.hpp"

#include "experiments/paper/figures/panels.hpp"

namespace fairway::reproduction {

io::Color color_of(DriverKind kind) {
  switch (kind) {
    case DriverKind::Smpc:
      return kSrcColor;
    case DriverKind::Ismpc:
      return kMdsrcColor;
    case DriverKind::Ours:
      break;
  }
  return kOursColor;
}

io::Stroke track_stroke(DriverKind kind) {
  switch (kind) {
    case DriverKind::Smpc:
      return {.color = color_of(kind), .width = 1.4, .dash = {5.0, 1.5}};
    case DriverKind::Ismpc:
      return {.color = color_of(kind), .width = 1.4};
    case DriverKind::Ours:
      break;
  }
  return {.color = color_of(kind), .width = 1.4, .dash = {1.6, 1.2}};
}

std::vector<Eigen::Vector2d> track_of(const Drive& drive) {
  std::vector<Eigen::Vector2d> track;
  for (const TraceRow& row : drive.rows)
    track.push_back(row.pose.position);
  return track;
}

}  // namespace fairway::reproduction
