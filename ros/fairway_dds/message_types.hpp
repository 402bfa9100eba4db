// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ros2_messages.h"

namespace fairway::dds {

/// The type description that idlc generated for a message.
template <typename Message>
[[nodiscard]] const dds_topic_descriptor_t& descriptor() noexcept;

template <>
inline const dds_topic_descriptor_t& descriptor<rosgraph_msgs_msg_dds__Clock_>() noexcept {
  return rosgraph_msgs_msg_dds__Clock__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<std_msgs_msg_dds__Empty_>() noexcept {
  return std_msgs_msg_dds__Empty__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<std_msgs_msg_dds__Float64_>() noexcept {
  return std_msgs_msg_dds__Float64__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<std_msgs_msg_dds__String_>() noexcept {
  return std_msgs_msg_dds__String__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<geometry_msgs_msg_dds__PoseStamped_>() noexcept {
  return geometry_msgs_msg_dds__PoseStamped__desc;
}
template <>
inline const dds_topic_descriptor_t&
descriptor<geometry_msgs_msg_dds__PoseWithCovarianceStamped_>() noexcept {
  return geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<geometry_msgs_msg_dds__Twist_>() noexcept {
  return geometry_msgs_msg_dds__Twist__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<geometry_msgs_msg_dds__TwistStamped_>() noexcept {
  return geometry_msgs_msg_dds__TwistStamped__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<nav_msgs_msg_dds__OccupancyGrid_>() noexcept {
  return nav_msgs_msg_dds__OccupancyGrid__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<nav_msgs_msg_dds__Odometry_>() noexcept {
  return nav_msgs_msg_dds__Odometry__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<nav_msgs_msg_dds__Path_>() noexcept {
  return nav_msgs_msg_dds__Path__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<sensor_msgs_msg_dds__LaserScan_>() noexcept {
  return sensor_msgs_msg_dds__LaserScan__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<sensor_msgs_msg_dds__PointCloud2_>() noexcept {
  return sensor_msgs_msg_dds__PointCloud2__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<tf2_msgs_msg_dds__TFMessage_>() noexcept {
  return tf2_msgs_msg_dds__TFMessage__desc;
}
template <>
inline const dds_topic_descriptor_t&
descriptor<visualization_msgs_msg_dds__MarkerArray_>() noexcept {
  return visualization_msgs_msg_dds__MarkerArray__desc;
}
template <>
inline const dds_topic_descriptor_t& descriptor<fairway_msgs_msg_dds__SharedMotion_>() noexcept {
  return fairway_msgs_msg_dds__SharedMotion__desc;
}

}  // namespace fairway::dds
