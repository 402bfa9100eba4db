// SPDX-License-Identifier: Apache-2.0
// The conversions that need Cyclone DDS: times, C strings and C sequences.
#pragma once

#include <vector>

#include "bridge/pilot.hpp"
#include "ros2_messages.h"

namespace fairway::dds {

[[nodiscard]] inline double seconds_of(const builtin_interfaces_msg_dds__Time_& time) noexcept {
  return static_cast<double>(time.sec) + 1e-9 * static_cast<double>(time.nanosec);
}
[[nodiscard]] builtin_interfaces_msg_dds__Time_ time_of(double seconds) noexcept;

/// The elements of a received sequence.
template <typename Sequence>
[[nodiscard]] auto elements(const Sequence& sequence) noexcept {
  return std::span(
      static_cast<const std::remove_reference_t<decltype(*sequence._buffer)>*>(sequence._buffer),
      sequence._length);
}

/// Makes a sequence to be sent refer to the elements, which must outlive the call that sends them.
template <typename Sequence, typename Element>
void point_to(std::vector<Element>& elements, Sequence& sequence) noexcept {
  sequence._buffer = elements.data();
  sequence._length = sequence._maximum = static_cast<std::uint32_t>(elements.size());
  sequence._release = false;
}

/// A header whose frame name must outlive the call that sends it.
[[nodiscard]] std_msgs_msg_dds__Header_ header(const std::string& frame, double time) noexcept;

struct ScanInput {
  LidarScan scan;         ///< its poses are not set
  double duration = 0.0;  ///< from the first beam to the last [s]
};
[[nodiscard]] ScanInput to_scan(const sensor_msgs_msg_dds__LaserScan_& message) noexcept;

[[nodiscard]] Expected<OccupancyGrid> to_grid(const nav_msgs_msg_dds__OccupancyGrid_& message);

/// Like bridge::read_obstacles, in the cloud's frame.
[[nodiscard]] Expected<std::vector<MovingObstacle>> to_obstacles(
    const sensor_msgs_msg_dds__PointCloud2_& message);

/// A path to be sent, with the memory of its contents.
class PathMessage {
 public:
  PathMessage(const Path& path, const std::string& frame, double time);
  PathMessage(const PathMessage&) = delete;
  PathMessage& operator=(const PathMessage&) = delete;
  [[nodiscard]] const nav_msgs_msg_dds__Path_& get() const noexcept { return message_; }

 private:
  std::string frame_;
  std::vector<geometry_msgs_msg_dds__PoseStamped_> poses_;
  nav_msgs_msg_dds__Path_ message_{};
};

/// The outlines of a corridor's rectangles as markers, after one that removes the previous ones.
class CorridorMessage {
 public:
  CorridorMessage(const Corridor& corridor, const std::string& frame, double time);
  CorridorMessage(const CorridorMessage&) = delete;
  CorridorMessage& operator=(const CorridorMessage&) = delete;
  [[nodiscard]] const visualization_msgs_msg_dds__MarkerArray_& get() const noexcept {
    return message_;
  }

 private:
  std::string frame_;
  std::vector<std::vector<geometry_msgs_msg_dds__Point_>> outlines_;
  std::vector<visualization_msgs_msg_dds__Marker_> markers_;
  visualization_msgs_msg_dds__MarkerArray_ message_{};
};

/// A text above the robot as a marker, in the robot's frame, so that it moves with the robot.
class StatusMarkerMessage {
 public:
  StatusMarkerMessage(const std::string& text, const std::string& base_frame, double time);
  StatusMarkerMessage(const StatusMarkerMessage&) = delete;
  StatusMarkerMessage& operator=(const StatusMarkerMessage&) = delete;
  [[nodiscard]] const visualization_msgs_msg_dds__MarkerArray_& get() const noexcept {
    return message_;
  }

 private:
  std::string text_;
  std::string frame_;
  std::vector<visualization_msgs_msg_dds__Marker_> markers_;
  visualization_msgs_msg_dds__MarkerArray_ message_{};
};

/// Another robot's published motion, with positions transformed from the message's frame. Samples
/// beyond the capacity are dropped.
[[nodiscard]] SharedMotion to_motion(const fairway_msgs_msg_dds__SharedMotion_& message,
                                     const Pose2& frame) noexcept;

/// This robot's motion to be published, with the memory of its contents.
class MotionMessage {
 public:
  MotionMessage(const SharedMotion& motion,
                const std::string& name,
                const std::string& frame,
                bool leaving);
  MotionMessage(const MotionMessage&) = delete;
  MotionMessage& operator=(const MotionMessage&) = delete;
  [[nodiscard]] const fairway_msgs_msg_dds__SharedMotion_& get() const noexcept { return message_; }

 private:
  std::string name_;
  std::string frame_;
  std::vector<geometry_msgs_msg_dds__Point_> plan_;
  std::vector<geometry_msgs_msg_dds__Point_> stop_;
  std::vector<geometry_msgs_msg_dds__Point_> way_;
  fairway_msgs_msg_dds__SharedMotion_ message_{};
};

}  // namespace fairway::dds
