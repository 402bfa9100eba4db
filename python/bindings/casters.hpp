// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "fairway/geometry/pose2.hpp"
#include "fairway/planning/plan.hpp"
#include "numbers.hpp"

// A pose, a point, a twist and a goal are tuples in Python; a path is an array with two columns.
// What does not fit is a ValueError, not a TypeError: no function here is overloaded.
namespace pybind11::detail {

template <>
struct type_caster<Eigen::Vector2d> {
  PYBIND11_TYPE_CASTER(Eigen::Vector2d, const_name("Point"));
  bool load(handle source, bool /*convert*/) {
    std::array<double, 2> n{};
    fairway::python::read_numbers(source, "point", "x, y", 2, n);
    value = {n[0], n[1]};
    return true;
  }
  static handle cast(const Eigen::Vector2d& point, return_value_policy /*p*/, handle /*parent*/) {
    return make_tuple(point.x(), point.y()).release();
  }
};

template <>
struct type_caster<fairway::Pose2> {
  PYBIND11_TYPE_CASTER(fairway::Pose2, const_name("Pose"));
  bool load(handle source, bool /*convert*/) {
    std::array<double, 3> n{};
    fairway::python::read_numbers(source, "pose", "x, y, heading", 3, n);
    value = {.position = {n[0], n[1]}, .heading = n[2]};
    return true;
  }
  static handle cast(const fairway::Pose2& pose, return_value_policy /*p*/, handle /*parent*/) {
    return make_tuple(pose.position.x(), pose.position.y(), pose.heading).release();
  }
};

template <>
struct type_caster<fairway::Twist2> {
  PYBIND11_TYPE_CASTER(fairway::Twist2, const_name("Twist"));
  bool load(handle source, bool /*convert*/) {
    std::array<double, 2> n{};
    fairway::python::read_numbers(source, "twist", "linear, angular", 2, n);
    value = {.linear = n[0], .angular = n[1]};
    return true;
  }
  static handle cast(const fairway::Twist2& twist, return_value_policy /*p*/, handle /*parent*/) {
    return make_tuple(twist.linear, twist.angular).release();
  }
};

template <>
struct type_caster<fairway::Goal> {
  PYBIND11_TYPE_CASTER(fairway::Goal, const_name("Goal"));
  bool load(handle source, bool /*convert*/) {
    std::array<double, 3> n{};
    const std::size_t count =
        fairway::python::read_numbers(source, "goal", "x, y or x, y, heading", 2, n);
    value = {.position = {n[0], n[1]}, .heading = {}};
    if (count == 3) value.heading = n[2];
    return true;
  }
  static handle cast(const fairway::Goal& goal, return_value_policy /*p*/, handle /*parent*/) {
    const Eigen::Vector2d& at = goal.position;
    return (goal.heading ? make_tuple(at.x(), at.y(), *goal.heading) : make_tuple(at.x(), at.y()))
        .release();
  }
};

template <>
struct type_caster<fairway::Path> {
  PYBIND11_TYPE_CASTER(fairway::Path, const_name("numpy.ndarray"));
  bool load(handle source, bool /*convert*/) {
    const fairway::python::NumberTable points = fairway::python::read_table(source, "path", 2);
    for (std::size_t i = 0; i < points.rows; ++i)
      value.waypoints.emplace_back(points.row(i)[0], points.row(i)[1]);
    return true;
  }
  static handle cast(const fairway::Path& path, return_value_policy /*p*/, handle /*parent*/) {
    return fairway::python::points_array(path.waypoints).release();
  }
};

}  // namespace pybind11::detail
