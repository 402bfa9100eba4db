// SPDX-License-Identifier: Apache-2.0
#include "bridge/frame_tree.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace fairway::bridge {
namespace {

constexpr double kStatic = std::numeric_limits<double>::infinity();
constexpr double kQuarter = 0.5 * std::numbers::pi;

FrameTree robot() {
  FrameTree tree;
  tree.set("map", "odom", {.position = {10, 0}, .heading = kQuarter}, 5.0);
  tree.set("odom", "base_link", {.position = {1, 0}, .heading = 0}, 6.0);
  tree.set("base_link", "laser", {.position = {0.5, 0}, .heading = 0}, kStatic);
  tree.set("base_link", "camera", {.position = {0, 0.5}, .heading = 0}, kStatic);
  return tree;
}

TEST(FrameTree, ComposesFromParentToChild) {
  const auto found = robot().find("map", "laser");
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->pose.position.isApprox(Eigen::Vector2d(10, 1.5)));
  EXPECT_NEAR(found->pose.heading, kQuarter, 1e-12);
  EXPECT_EQ(found->time, 5.0) << "the oldest stamp of the chain";
}

TEST(FrameTree, InvertsFromChildToParentAndConnectsBranches) {
  const auto up = robot().find("base_link", "odom");
  ASSERT_TRUE(up);
  EXPECT_TRUE(up->pose.position.isApprox(Eigen::Vector2d(-1, 0)));
  const auto across = robot().find("laser", "camera");
  ASSERT_TRUE(across);
  EXPECT_TRUE(across->pose.position.isApprox(Eigen::Vector2d(-0.5, 0.5)));
  EXPECT_EQ(across->time, kStatic);
}

TEST(FrameTree, KnowsEveryFrameInItself) {
  const auto found = FrameTree().find("anything", "anything");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->pose.position, Eigen::Vector2d::Zero());
}

TEST(FrameTree, GivesNoPoseBetweenUnconnectedFramesAndEndsInCycles) {
  FrameTree tree = robot();
  EXPECT_FALSE(tree.find("map", "elsewhere"));
  tree.set("b", "a", {}, 0.0);
  tree.set("a", "b", {}, 0.0);
  EXPECT_FALSE(tree.find("map", "a"));
  EXPECT_FALSE(tree.find("a", "map"));
}

TEST(FrameTree, RefusesPosesThatAreNotFinite) {
  FrameTree tree = robot();
  tree.set("map", "odom", {.position = {std::nan(""), 0}, .heading = 0}, 9.0);
  EXPECT_EQ(tree.find("map", "odom")->time, 5.0);
}

}  // namespace
}  // namespace fairway::bridge
