// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/fleet_radio.hpp"

namespace fairway {

namespace {

constexpr double kSameTime = 1e-9;       // [s]
constexpr std::size_t kRemembered = 64;  // messages kept per robot when they can be late or lost

}  // namespace

FleetRadio::FleetRadio(const RadioModel& model, std::size_t robots, std::uint64_t seed)
    : model_(model),
      noise_(seed),
      told_(robots),
      places_(robots, Eigen::Vector2d::Zero()) {}

void FleetRadio::tell(std::size_t robot, const SharedMotion& motion) {
  std::deque<Message>& told = told_[robot];
  const std::size_t kept = model_.delay > 0.0 || model_.loss > 0.0 ? kRemembered : 1;
  if (told.size() == kept) told.pop_front();
  told.push_back({.motion = motion, .lost = {}});
  places_[robot] = motion.position;
  if (model_.loss <= 0.0 || told.size() == 1) return;
  std::vector<bool>& lost = told.back().lost;
  for (std::size_t i = 0; i < told_.size(); ++i)
    lost.push_back(noise_.uniform(0.0, 1.0) < model_.loss);
}

const FleetRadio::Message* FleetRadio::newest(std::size_t from, std::size_t to, double time) const {
  const std::deque<Message>& told = told_[from];
  for (auto message = told.rbegin(); message != told.rend(); ++message) {
    if (message->motion.time + model_.delay > time + kSameTime) continue;
    if (message->lost.empty() || (to < message->lost.size() && !message->lost[to]))
      return &*message;
  }
  return told.empty() ? nullptr : &told.front();
}

Fleet FleetRadio::hear(std::size_t robot, const Eigen::Vector2d& position, double time) {
  heard_.clear();
  const bool exact = model_.delay <= 0.0 && model_.loss <= 0.0;
  for (std::size_t other = 0; other < told_.size(); ++other) {
    if (other == robot) continue;
    // Without delay and loss the only message is the newest one.
    if (exact && (places_[other] - position).norm() > model_.range) continue;
    const Message* message = newest(other, robot, time);
    if (message == nullptr) continue;
    if ((message->motion.position - position).norm() > model_.range) continue;
    heard_.push_back({.motion = &message->motion,
                      .unseen = exact ? 0.0 : std::fmax(0.0, time - message->motion.time)});
  }
  return heard_;
}

}  // namespace fairway
