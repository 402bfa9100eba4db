// SPDX-License-Identifier: Apache-2.0
#include "bridge/fleet_board.hpp"

#include <algorithm>

namespace fairway::bridge {

// FNV-1a is short, and gives the same numbers everywhere.
std::uint32_t robot_number(std::string_view name) noexcept {
  std::uint32_t hash = 2166136261U;
  for (const char c : name) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 16777619U;
  }
  return hash;
}

bool FleetBoard::receive(const std::string& name, const SharedMotion& motion, double now) {
  if (!is_plausible(motion) || !(motion.time <= now + kMostAhead)) return false;
  const auto known = told_.find(name);
  if (known == told_.end()) {
    told_.emplace(name, motion);
  } else if (motion.time >= known->second.time) {
    known->second = motion;
  }
  return true;
}

Fleet FleetBoard::around(const Eigen::Vector2d& position, double time) {
  around_.clear();
  for (const auto& [name, motion] : told_) {
    const double unseen = std::max(0.0, time - motion.time);
    const double away = (motion.position - position).norm();
    if (away > kRange + motion.speed_max * unseen) continue;
    around_.push_back({.motion = &motion, .unseen = unseen});
  }
  return around_;
}

}  // namespace fairway::bridge
