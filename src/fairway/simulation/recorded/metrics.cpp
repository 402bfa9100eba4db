// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/recorded/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fairway/base/contract.hpp"

namespace fairway {

double quantile(std::span<const double> sorted, double share) {
  FAIRWAY_EXPECTS(!sorted.empty());
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

Quantiles quantiles(std::span<const double> sample) {
  if (sample.empty()) return {};
  std::vector<double> sorted(sample.begin(), sample.end());
  std::sort(sorted.begin(), sorted.end());
  return {.median = quantile(sorted, 0.5), .p99 = quantile(sorted, 0.99), .max = sorted.back()};
}

double smoothness(const Trace& trace, std::size_t robot) {
  const TraceRow* last = nullptr;
  double sum = 0.0;
  for (const TraceRow& row : trace.rows) {
    if (row.robot != robot) continue;
    if (last != nullptr && row.time > last->time) {
      const double du = row.command.linear - last->command.linear;
      const double dr = row.command.angular - last->command.angular;
      sum += (du * du + dr * dr) / (row.time - last->time);
    }
    last = &row;
  }
  return sum;
}

int rectangle_switches(const Trace& trace, std::size_t robot) {
  const TraceRow* last = nullptr;
  int switches = 0;
  for (const TraceRow& row : trace.rows) {
    if (row.robot != robot) continue;
    if (last != nullptr && row.rectangle != last->rectangle) ++switches;
    last = &row;
  }
  return switches;
}

}  // namespace fairway
