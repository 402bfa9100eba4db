// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <vector>

#include "fairway/prediction/shared_motion.hpp"
#include "fairway/simulation/sensors/noise.hpp"

namespace fairway {

/// How the robots of a scenario hear each other.
struct RadioModel {
  bool on = true;       ///< off: a robot knows of others what it sees, as of anything that moves
  double delay = 0.0;   ///< of every message [s]; 0: who is controlled next has heard it already
  double loss = 0.0;    ///< share of messages that a robot does not hear, each for itself
  double range = 15.0;  ///< within which robots hear each other [m]
};

/// Carries what robots tell each other, late and with gaps as the model says.
///
/// With neither delay nor loss the robots are controlled in turn and each knows all that was told
/// before: nothing is unseen. Otherwise a message is as old as it is, and what its robot has told
/// since is unseen.
class FleetRadio {
 public:
  FleetRadio(const RadioModel& model, std::size_t robots, std::uint64_t seed);

  [[nodiscard]] const RadioModel& model() const noexcept { return model_; }

  /// A robot tells all others. The first thing that it tells is heard by all at once.
  void tell(std::size_t robot, const SharedMotion& motion);

  /// What robot `robot` knows at `time` [s] of those in range; valid until the next call of either
  /// function.
  [[nodiscard]] Fleet hear(std::size_t robot, const Eigen::Vector2d& position, double time);

 private:
  struct Message {
    SharedMotion motion;
    std::vector<bool> lost;  // per receiver; empty: heard by all
  };

  [[nodiscard]] const Message* newest(std::size_t from, std::size_t to, double time) const;

  RadioModel model_;
  Noise noise_;
  std::vector<std::deque<Message>> told_;  // per robot, oldest first
  std::vector<FleetMember> heard_;
};

}  // namespace fairway
