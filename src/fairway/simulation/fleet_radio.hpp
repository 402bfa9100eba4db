// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <vector>

#include "fairway/prediction/moving_obstacle.hpp"
#include "fairway/simulation/sensors/noise.hpp"

namespace fairway {

/// How the robots of a scenario communicate.
struct RadioModel {
  bool on = true;       ///< off: a robot only sees other robots, as any moving obstacle
  double delay = 0.0;   ///< of every message [s]; 0: the robot controlled next has received it
  double loss = 0.0;    ///< share of messages that a robot misses, drawn for each receiver
  double range = 15.0;  ///< distance within which robots receive each other [m]
};

/// Carries the messages between robots, with the delay and losses of the model.
///
/// With neither delay nor loss the robots are controlled in turn. Each robot then knows all earlier
/// messages, so no motion is unseen. Otherwise a robot knows the newest message that it has
/// received, and the motion since then is unseen.
class FleetRadio {
 public:
  FleetRadio(const RadioModel& model, std::size_t robots, std::uint64_t seed);

  [[nodiscard]] const RadioModel& model() const noexcept { return model_; }

  /// Publishes a motion to all other robots. The first message of a robot reaches all at once.
  void tell(std::size_t robot, const SharedMotion& motion);

  /// Adds a robot, which has published nothing yet.
  void add_robot() {
    told_.emplace_back();
    places_.emplace_back(Eigen::Vector2d::Zero());
  }

  /// Drops the messages of a robot that was removed.
  void forget(std::size_t robot) { told_[robot].clear(); }

  /// Returns the motions that robot `robot` knows at `time` [s], of the robots in range. The result
  /// is valid until the next call of either function.
  [[nodiscard]] Fleet hear(std::size_t robot, const Eigen::Vector2d& position, double time);

 private:
  struct Message {
    SharedMotion motion;
    std::vector<bool> lost;  // per receiver; empty: received by all
  };

  [[nodiscard]] const Message* newest(std::size_t from, std::size_t to, double time) const;

  RadioModel model_;
  Noise noise_;
  std::vector<std::deque<Message>> told_;  // per robot, oldest first
  std::vector<Eigen::Vector2d> places_;    // of the newest messages, close together in memory
  std::vector<FleetMember> heard_;
};

}  // namespace fairway
