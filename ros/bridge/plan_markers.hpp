// SPDX-License-Identifier: Apache-2.0
// Markers for rviz as templates, because ROS 1 and ROS 2 have different C++ types with the same
// fields (visualization_msgs/MarkerArray).
#pragma once

#include <cstddef>
#include <string>

#include "fairway/corridor/corridor.hpp"

namespace fairway::bridge {

/// Appends a marker that removes all earlier ones of the topic.
template <typename MarkerArray, typename Header>
void add_clearing(const Header& header, MarkerArray& array) {
  constexpr int kDeleteAll = 3;
  array.markers.emplace_back();
  auto& marker = array.markers.back();
  marker.header = header;
  marker.action = kDeleteAll;
  marker.pose.orientation.w = 1.0;
}

/// Appends the outlines of a corridor. @param current  Index of the rectangle with the robot, which
/// is highlighted.
template <typename MarkerArray, typename Header>
void add_corridor(const Corridor& corridor,
                  std::size_t current,
                  const Header& header,
                  MarkerArray& array) {
  constexpr int kLineStrip = 4;
  for (std::size_t i = 0; i < corridor.rectangles.size(); ++i) {
    array.markers.emplace_back();
    auto& marker = array.markers.back();
    marker.header = header;
    marker.ns = "corridor";
    marker.id = static_cast<int>(i);
    marker.type = kLineStrip;
    marker.pose.orientation.w = 1.0;
    marker.scale.x = i == current ? 0.05 : 0.03;
    marker.color.r = 0.1F;
    marker.color.g = i == current ? 0.8F : 0.5F;
    marker.color.b = i == current ? 0.4F : 0.9F;
    marker.color.a = 0.9F;
    const auto corners = corridor.rectangles[i].corners();
    for (std::size_t c = 0; c <= corners.size(); ++c) {
      marker.points.emplace_back();
      marker.points.back().x = corners[c % corners.size()].x();
      marker.points.back().y = corners[c % corners.size()].y();
      marker.points.back().z = 0.02;
    }
  }
}

/// Appends a text above the robot. @param header  Of the robot's frame, so that the text moves with
/// the robot.
template <typename MarkerArray, typename Header>
void add_text(const std::string& text, const Header& header, MarkerArray& array) {
  constexpr int kText = 9;
  array.markers.emplace_back();
  auto& marker = array.markers.back();
  marker.header = header;
  marker.ns = "status";
  marker.id = 0;
  marker.type = kText;
  marker.frame_locked = true;
  marker.pose.position.z = 0.8;
  marker.pose.orientation.w = 1.0;
  marker.scale.z = 0.2;
  marker.color.r = marker.color.g = marker.color.b = 0.2F;
  marker.color.a = 1.0F;
  marker.text = text;
}

}  // namespace fairway::bridge
