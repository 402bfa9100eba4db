// SPDX-License-Identifier: Apache-2.0
// Not ROS 2: doubles of tf2, of costmaps, and of the goal checkers of Nav2; see rclcpp_double.hpp.
#pragma once

#include "rclcpp_double.hpp"

namespace tf2 {
struct TimePoint {};
inline constexpr TimePoint TimePointZero;
class TransformException : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
}  // namespace tf2

namespace tf2_ros {
class Buffer {
 public:
  geometry_msgs::msg::TransformStamped lookupTransform(const std::string& to,
                                                       const std::string& from,
                                                       const tf2::TimePoint& /*time*/) const {
    const auto found = transforms.find({to, from});
    if (found == transforms.end()) throw tf2::TransformException("no " + from + " in " + to);
    return found->second;
  }
  geometry_msgs::msg::TransformStamped lookupTransform(const std::string& to,
                                                       const std::string& from,
                                                       const rclcpp::Time& time,
                                                       const rclcpp::Duration& /*timeout*/) const {
    if (time.seconds() > newest) throw tf2::TransformException("in the future");
    return lookupTransform(to, from, tf2::TimePointZero);
  }

  // For tests only: the pose of the second frame in the first, and the time of the newest one.
  std::map<std::pair<std::string, std::string>, geometry_msgs::msg::TransformStamped> transforms;
  double newest = 1e9;
};
}  // namespace tf2_ros

namespace nav2_costmap_2d {
class Costmap2D {
 public:
  using mutex_t = std::recursive_mutex;
  const unsigned char* getCharMap() const { return cells.data(); }
  unsigned int getSizeInCellsX() const { return width; }
  unsigned int getSizeInCellsY() const { return height; }
  double getOriginX() const { return origin_x; }
  double getOriginY() const { return origin_y; }
  double getResolution() const { return resolution; }
  mutex_t* getMutex() { return &mutex; }

  unsigned int width = 0;
  unsigned int height = 0;
  double resolution = 0.05;
  double origin_x = 0.0;
  double origin_y = 0.0;
  std::vector<unsigned char> cells;
  mutex_t mutex;
};
class Costmap2DROS {
 public:
  bool isCurrent() { return current; }
  Costmap2D* getCostmap() { return &costmap; }
  std::vector<geometry_msgs::msg::Point> getRobotFootprint() { return footprint; }
  std::string getGlobalFrameID() { return "odom"; }
  std::string getBaseFrameID() { return "base_link"; }

  Costmap2D costmap;
  bool current = true;
  std::vector<geometry_msgs::msg::Point> footprint;
};
}  // namespace nav2_costmap_2d

namespace nav2_core {
class GoalChecker {
 public:
  virtual ~GoalChecker() = default;
  virtual bool getTolerances(geometry_msgs::msg::Pose& pose_tolerance,
                             geometry_msgs::msg::Twist& vel_tolerance) = 0;
};
}  // namespace nav2_core

#define PLUGINLIB_EXPORT_CLASS(derived, base) \
  static_assert(!std::is_abstract_v<derived> && std::is_base_of_v<base, derived>);
