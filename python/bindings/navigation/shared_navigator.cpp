// SPDX-License-Identifier: Apache-2.0
#include "navigation/shared_navigator.hpp"

#include <numbers>

namespace fairway::python {

Scan make_scan(double time,
               const py::object& ranges,
               const Pose2& pose,
               double first_angle,
               const std::optional<double>& angle_step,
               std::pair<double, double> range_limits,
               const std::optional<Pose2>& last_pose,
               const std::optional<Eigen::Vector2d>& position) {
  using Ranges = py::array_t<float, py::array::c_style | py::array::forcecast>;
  const Ranges values = Ranges::ensure(ranges);
  if (!values) PyErr_Clear();
  if (!values || values.ndim() != 1) refuse("ranges", "an array with one range per beam", ranges);
  const auto count = static_cast<std::size_t>(values.size());
  Scan scan;
  scan.ranges.assign(values.data(), values.data() + count);
  scan.scan = {.time = time,
               .first_pose = pose,
               .last_pose = last_pose.value_or(pose),
               .first_angle = first_angle,
               .angle_step = angle_step.value_or(2.0 * std::numbers::pi /
                                                 static_cast<double>(count > 0 ? count : 1)),
               .min_range = range_limits.first,
               .max_range = range_limits.second,
               .ranges = scan.ranges};
  scan.position = position.value_or(pose.position);
  return scan;
}

void OwnedMeasurements::read(const py::object& obstacle_table, const py::object& fleet_list) {
  if (!obstacle_table.is_none()) {
    const NumberTable table = read_table(obstacle_table, "obstacles", 5);
    for (std::size_t i = 0; i < table.rows; ++i) {
      const double* const n = table.row(i);
      obstacles.push_back({.position = {n[0], n[1]}, .velocity = {n[2], n[3]}, .radius = n[4]});
    }
    measurements.obstacles = obstacles;
  }
  if (fleet_list.is_none()) return;
  std::vector<double> unseen;
  for (const py::handle member : fleet_list) {
    const bool pair = py::isinstance<py::tuple>(member);
    const auto list =
        pair ? py::reinterpret_borrow<py::tuple>(member) : py::make_tuple(member, 0.0);
    if (list.size() != 2 || !py::isinstance<SharedMotion>(list[0]))
      refuse("fleet", "messages, or pairs of a message and a time", member);
    motions.push_back(list[0].cast<const SharedMotion&>());
    unseen.push_back(list[1].cast<double>());
  }
  for (std::size_t i = 0; i < motions.size(); ++i)
    fleet.push_back({.motion = &motions[i], .unseen = unseen[i]});
  measurements.fleet = fleet;
}

}  // namespace fairway::python
