// SPDX-License-Identifier: Apache-2.0
// Differences between Nav2's distributions, which are identified by their headers:
//   humble          nav2_core/exceptions.hpp; setPlan, 3 arguments; createPlan with 2
//   jazzy, kilted   controller_exceptions.hpp, planner_exceptions.hpp; cancel, reset; createPlan
//                   with a cancel checker
//   lyrical         nav2_ros_common; newPathReceived, 5 arguments; createPlan with via points
#pragma once

#if __has_include(<nav2_ros_common/lifecycle_node.hpp>)
#define FAIRWAY_NAV2_LYRICAL 1
#include <nav2_ros_common/lifecycle_node.hpp>
#else
#define FAIRWAY_NAV2_LYRICAL 0
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#endif

#if __has_include(<nav2_core/controller_exceptions.hpp>)
#define FAIRWAY_NAV2_TYPED_EXCEPTIONS 1
#include <nav2_core/controller_exceptions.hpp>
#include <nav2_core/planner_exceptions.hpp>
#else
#define FAIRWAY_NAV2_TYPED_EXCEPTIONS 0
#include <nav2_core/exceptions.hpp>
#endif

#if __has_include(<tf2_ros/buffer.hpp>)
#include <tf2_ros/buffer.hpp>
#else
#include <tf2_ros/buffer.h>
#endif

#include <memory>
#include <string>

namespace fairway::nav2 {

#if FAIRWAY_NAV2_LYRICAL
using LifecycleNode = ::nav2::LifecycleNode;
#else
using LifecycleNode = rclcpp_lifecycle::LifecycleNode;
#endif
using TransformBuffer = std::shared_ptr<tf2_ros::Buffer>;

#if FAIRWAY_NAV2_TYPED_EXCEPTIONS
using ControllerTransformError = nav2_core::ControllerTFError;
using NoValidControl = nav2_core::NoValidControl;
using InvalidPath = nav2_core::InvalidPath;
using ControllerSetupError = nav2_core::InvalidController;
using PlannerCancelled = nav2_core::PlannerCancelled;
using PlannerTransformError = nav2_core::PlannerTFError;
using StartOccupied = nav2_core::StartOccupied;
using GoalOccupied = nav2_core::GoalOccupied;
using StartOutsideMap = nav2_core::StartOutsideMapBounds;
using GoalOutsideMap = nav2_core::GoalOutsideMapBounds;
using NoValidPath = nav2_core::NoValidPathCouldBeFound;
#else  // Humble has one exception type, which its controller server catches
using ControllerTransformError = nav2_core::PlannerException;
using NoValidControl = nav2_core::PlannerException;
using InvalidPath = nav2_core::PlannerException;
using ControllerSetupError = nav2_core::PlannerException;
using PlannerCancelled = nav2_core::PlannerException;
using PlannerTransformError = nav2_core::PlannerException;
using StartOccupied = nav2_core::PlannerException;
using GoalOccupied = nav2_core::PlannerException;
using StartOutsideMap = nav2_core::PlannerException;
using GoalOutsideMap = nav2_core::PlannerException;
using NoValidPath = nav2_core::PlannerException;
#endif

}  // namespace fairway::nav2
