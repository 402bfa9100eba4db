// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/trace_file.hpp"

#include <iterator>

#include <fmt/core.h>

namespace fairway::io {

namespace {

// Puts a field in quotes where necessary (RFC 4180).
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace

std::string trace_csv(const EpisodeResult& episode) {
  std::string text =
      "time,robot,x,y,heading,linear,angular,status,command_linear,command_angular,limit,rectangle,"
      "clearance";
  text += episode.trace.lateral ? ",lateral\n" : "\n";
  auto out = std::back_inserter(text);
  for (const TraceRow& row : episode.trace.rows) {
    fmt::format_to(
        out, "{:.9g},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{},{:.9g},{:.9g},{},{},{:.9g}", row.time,
        field(episode.robots[row.robot].name), row.pose.position.x(), row.pose.position.y(),
        row.pose.heading, row.twist.linear, row.twist.angular, to_text(row.status),
        row.command.linear, row.command.angular, to_text(row.limit), row.rectangle, row.clearance);
    if (episode.trace.lateral) fmt::format_to(out, ",{:.9g}", row.lateral);
    text += '\n';
  }
  return text;
}

}  // namespace fairway::io
