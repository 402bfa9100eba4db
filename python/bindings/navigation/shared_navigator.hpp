// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "casters.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/perception/lidar_scan.hpp"
#include "navigation/step.hpp"

namespace fairway::python {

/// A navigator that several threads of Python may hold. Calls run one after the other and without
/// the GIL, so that a plan or a solve stops no other thread.
template <typename Navigator>
class SharedNavigator {
 public:
  template <typename... Arguments>
  explicit SharedNavigator(Arguments&&... arguments)
      : navigator_(std::forward<Arguments>(arguments)...) {}

  /// Runs `call(navigator)`, which must not use Python.
  template <typename Call>
  auto run(Call&& call) {
    const py::gil_scoped_release release;
    const std::scoped_lock lock(mutex_);
    return call(navigator_);
  }

 private:
  std::mutex mutex_;
  Navigator navigator_;
};

/// One lidar scan: its beams and a copy of its ranges.
struct Scan {
  LidarScan scan;
  std::vector<float> ranges;
  Eigen::Vector2d position;  ///< of the robot [m]
};

/// Makes a scan from the arguments of `observe`.
[[nodiscard]] Scan make_scan(double time,
                             const py::object& ranges,
                             const Pose2& pose,
                             double first_angle,
                             const std::optional<double>& angle_step,
                             std::pair<double, double> range_limits,
                             const std::optional<Pose2>& last_pose,
                             const std::optional<Eigen::Vector2d>& position);

/// The measurements of a cycle, with the lists that they refer to.
struct OwnedMeasurements {
  Measurements measurements;
  std::vector<MovingObstacle> obstacles;
  std::vector<SharedMotion> motions;
  std::vector<FleetMember> fleet;

  /// @param fleet_list  Messages, or pairs of a message and the time for which it is unseen [s].
  void read(const py::object& obstacle_table, const py::object& fleet_list);
};

}  // namespace fairway::python
