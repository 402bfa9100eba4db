// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/studies/drive_runs.hpp"

#include <algorithm>

namespace fairway::reproduction {

double value_of(const Drive& drive, DriveMeasure measure) {
  switch (measure) {
    case DriveMeasure::Length:
      return drive.length;
    case DriveMeasure::Time:
      return drive.time;
    case DriveMeasure::Smoothness:
      return drive.smoothness;
    case DriveMeasure::Switches:
      return drive.switches;
  }
  return 0.0;
}

const char* to_text(DriveMeasure measure) noexcept {
  switch (measure) {
    case DriveMeasure::Length:
      return "length [m]";
    case DriveMeasure::Time:
      return "time [s]";
    case DriveMeasure::Smoothness:
      return "smoothness";
    case DriveMeasure::Switches:
      return "switches";
  }
  return "unknown";
}

std::vector<const DriveComparison*> DriveRuns::comparable() const {
  std::vector<const DriveComparison*> result;
  for (const DriveComparison& map : maps) {
    if (map.all_reached()) result.push_back(&map);
  }
  return result;
}

int DriveRuns::reached(DriverKind kind) const {
  return static_cast<int>(std::count_if(
      maps.begin(), maps.end(), [&](const DriveComparison& map) { return map.of(kind).reached; }));
}

int DriveRuns::collided(DriverKind kind) const {
  return static_cast<int>(std::count_if(
      maps.begin(), maps.end(), [&](const DriveComparison& map) { return map.of(kind).collided; }));
}

std::vector<double> values(const DriveRuns& runs, DriverKind kind, DriveMeasure measure) {
  std::vector<double> result;
  for (const DriveComparison* map : runs.comparable())
    result.push_back(value_of(map->of(kind), measure));
  return result;
}

Estimate change(const DriveRuns& runs, DriverKind kind, DriverKind base, DriveMeasure measure) {
  return estimate(percent_over(values(runs, kind, measure), values(runs, base, measure)));
}

}  // namespace fairway::reproduction
