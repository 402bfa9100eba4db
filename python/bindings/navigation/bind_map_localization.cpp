// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <numbers>

#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/perception/map_localization.hpp"
#include "navigation/shared_navigator.hpp"

namespace fairway::python {

namespace {

py::array_t<double> covariance_of(const MapPose& found) {
  py::array_t<double> array({3, 3});
  auto cells = array.mutable_unchecked<2>();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      cells(row, column) = found.covariance(row, column);
  }
  return array;
}

bool observe_scan(MapLocalization& self,
                  double time,
                  const py::object& ranges,
                  const Pose2& pose,
                  double first_angle,
                  const std::optional<double>& angle_step,
                  double min_range,
                  double max_range,
                  const std::optional<Pose2>& last_pose) {
  const Scan scan = make_scan(time, ranges, pose, first_angle, angle_step, {min_range, max_range},
                              last_pose, std::nullopt);
  return self.observe(scan.scan);
}

}  // namespace

void bind_map_localization(py::module_& module) {
  py::class_<MapPose>(module, "MapPose",
                      "The pose of a robot in a map, as estimated from odometry and scans.")
      .def_readonly("pose", &MapPose::pose, "(x, y, heading) [m, m, rad].")
      .def_property_readonly("covariance", &covariance_of,
                             "Of x, y and the heading, in the frame of the map, 3 x 3.")
      .def_readonly("matched", &MapPose::matched,
                    "Whether the last scan fitted the map; if not, odometry alone was used.")
      .def_readonly("share", &MapPose::share,
                    "Part of the last scan that lies on surfaces of the map.")
      .def_readonly("degenerate", &MapPose::degenerate,
                    "Whether the last scan says nothing about the position in one direction.")
      .def_readonly("weak_direction", &MapPose::weak_direction, "That direction.");
  py::class_<MapLocalization>(
      module, "MapLocalization",
      "Tracks the pose of a robot in a known map from odometry and lidar scans, for robots without "
      "another localisation. Not for several threads at once.")
      .def(py::init([](const OccupancyGrid& map, const Settings* settings) {
             return std::make_unique<MapLocalization>(
                 map, settings != nullptr ? settings->perception : PerceptionSettings{});
           }),
           py::arg("map"), py::arg("settings") = py::none(),
           "Of the settings `perception.reach` and `.max_beams` are used.")
      .def("set_pose", &MapLocalization::set_pose, py::arg("odometry"), py::arg("pose"),
           py::arg("position_sigma") = 0.05, py::arg("heading_sigma") = 0.02,
           "Sets the robot's pose in the map, for a pose by odometry, and its standard deviations "
           "[m, rad].")
      .def("observe", &observe_scan, py::arg("time"), py::arg("ranges"), py::arg("pose"),
           py::kw_only(), py::arg("first_angle") = -std::numbers::pi,
           py::arg("angle_step") = py::none(), py::arg("min_range") = 0.0,
           py::arg("max_range") = 30.0, py::arg("last_pose") = py::none(),
           "Matches a scan, and returns whether it is plausible. `pose` is that of the sensor at "
           "the first beam, by odometry; the others as in MapNavigator.observe.")
      .def("locate", &MapLocalization::locate, py::arg("odometry"),
           "Returns the pose in the map for a pose by odometry.");
}

}  // namespace fairway::python
