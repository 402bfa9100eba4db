// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "fairway/io/web_report/compact_fields.hpp"
#include "fairway/simulation/episode_observer.hpp"

// The fields that several records of a RunStream share.
namespace fairway::io {

/// A map's frame: width and height [cells], resolution, and the pose of its origin.
void append_frame(CompactFields& out, const GridFrame& frame);

/// Run-length encodes `count` cells, line by line of the map.
template <typename ValueAt>
void append_cells(CompactFields& out, std::size_t count, const ValueAt& value_at) {
  for (std::size_t i = 0; i < count;) {
    const std::uint64_t value = value_at(i);
    std::size_t end = i + 1;
    while (end < count && value_at(end) == value)
      ++end;
    out.count(value);
    out.count(end - i);
    i = end;
  }
}

/// All cells of a map: its slot, 1 for "whole", the time, the frame, and the cells' values.
template <typename ValueAt>
void append_whole_map(CompactFields& out,
                      std::uint64_t slot,
                      double time,
                      const GridFrame& frame,
                      const ValueAt& value_at) {
  out.count(slot);
  out.count(1);
  out.time(time);
  append_frame(out, frame);
  append_cells(out, static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height),
               value_at);
}

/// The fields of a complete map that a robot sees: 1 where a cell is blocked, else 0.
[[nodiscard]] std::string seen_map_fields(std::uint64_t slot, double time, const BitGrid& grid);

void append_mark(CompactFields& out, const LimitMark& mark);
/// The horizon, or 0 when there is no plan; then iterations, violation and positions.
void append_prediction(CompactFields& out, const MpcSolution* plan);
void append_obstacles(CompactFields& out, std::span<const MovingObstacle> obstacles);
/// `flags`, plus 2 when the goal has a heading; then the goal.
void append_goal(CompactFields& out, const Goal& goal, unsigned flags);

}  // namespace fairway::io
