// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fairway/fleet/fleet_coordinator.hpp"

namespace fairway::test {

/// Robots at standstill that publish where they are and where they drive, and their coordinators.
class PublishingFleet : public testing::Test {
 protected:
  static constexpr double kRadius = 0.25;  // [m]
  static constexpr double kPeriod = 0.1;   // [s]

  struct Member {
    Eigen::Vector2d position;
    Eigen::Vector2d goal;
    FleetCoordinator coordinator{};
    ReferencePath path{};
    SharedMotion motion{};
    bool stopped = false;
    bool follows_own_path = true;
  };

  void add(const Eigen::Vector2d& position, const Eigen::Vector2d& goal) {
    members_.push_back({.position = position, .goal = goal});
    publish();
  }

  // One cycle of every robot, each with the messages of the cycle before.
  void cycle() {
    for (std::size_t i = 0; i < members_.size(); ++i)
      cycle(i);
    publish();
  }

  void cycle(std::size_t i) {
    Member& self = members_[i];
    std::vector<FleetMember> others;
    for (const Member& other : members_) {
      if (&other != &self) others.push_back({.motion = &other.motion});
    }
    own_ = path_of(self);
    const ReferencePath& followed = self.coordinator.update(own_, {.speed_max = 1.0,
                                                                   .radius = kRadius,
                                                                   .stopped = self.stopped,
                                                                   .dt = kPeriod,
                                                                   .robot = number(i),
                                                                   .fleet = others,
                                                                   .obstacles = &map_});
    self.follows_own_path = &followed == &own_;
    self.path = followed;
  }

  void publish() {
    for (std::size_t i = 0; i < members_.size(); ++i) {
      Member& self = members_[i];
      self.motion.robot = number(i);
      self.motion.position = self.position;
      self.motion.radius = kRadius;
      self.motion.speed_max = 1.0;
      self.motion.acceleration = 2.0;
      self.motion.turn_max = 1.5;
      self.motion.under_way = true;
      self.motion.way.count = 1;
      self.motion.way.points[0] = self.goal;
      self.motion.roundabout = self.coordinator.roundabout();
      self.motion.distance_to_bottleneck = self.coordinator.distance_to_bottleneck();
      self.motion.can_step_aside = self.coordinator.can_step_aside();
      self.motion.retreat_length = self.coordinator.retreat_length();
    }
  }

  void run(double duration) {
    const int cycles = static_cast<int>(std::lround(duration / kPeriod));
    for (int k = 0; k < cycles; ++k)
      cycle();
  }

  [[nodiscard]] int count_waiting() const {
    int waiting = 0;
    for (const Member& member : members_)
      waiting += member.coordinator.waits() ? 1 : 0;
    return waiting;
  }

  // A passage of 0.9 m along x at y = 5, from x = 4 to x = 16, between two rooms.
  void build_passage() {
    for (int y = 0; y < 100; ++y) {
      for (int x = 40; x < 160; ++x)
        map_.set({x, y}, y < 46 || y >= 55);
    }
  }

  static ReferencePath path_of(const Member& member) {
    ReferencePath path;
    path.count = 2;
    path.points[0] = member.position;
    path.points[1] = member.goal;
    path.arc[0] = 0.0;
    path.arc[1] = (member.goal - member.position).norm();
    path.ends_at_goal = true;
    return path;
  }

  [[nodiscard]] std::uint32_t number(std::size_t i) const {
    return first_number_ + static_cast<std::uint32_t>(i);
  }

  BitGrid map_{GridFrame{.width = 200, .height = 100, .resolution = 0.1, .origin = {}}, false};
  std::vector<Member> members_;
  std::uint32_t first_number_ = 0;

 private:
  ReferencePath own_;
};

}  // namespace fairway::test
