// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <pybind11/numpy.h>

#include "fairway/simulation/episode.hpp"

namespace fairway::python {

/// A row of the trace as NumPy has it.
struct TraceRecord {
  double time, x, y, heading, linear, angular, command_linear, command_angular, clearance;
  std::int32_t robot, status, limit, rectangle;
};

/// The trace as a structured array, one row per robot and cycle.
[[nodiscard]] inline pybind11::array_t<TraceRecord> trace_array(const EpisodeResult& result) {
  pybind11::array_t<TraceRecord> array(static_cast<pybind11::ssize_t>(result.trace.rows.size()));
  TraceRecord* out = array.mutable_data();
  for (const TraceRow& row : result.trace.rows) {
    *out++ = {.time = row.time,
              .x = row.pose.position.x(),
              .y = row.pose.position.y(),
              .heading = row.pose.heading,
              .linear = row.twist.linear,
              .angular = row.twist.angular,
              .command_linear = row.command.linear,
              .command_angular = row.command.angular,
              .clearance = row.clearance,
              .robot = static_cast<std::int32_t>(row.robot),
              .status = static_cast<std::int32_t>(row.status),
              .limit = static_cast<std::int32_t>(row.limit),
              .rectangle = static_cast<std::int32_t>(row.rectangle)};
  }
  return array;
}

}  // namespace fairway::python
