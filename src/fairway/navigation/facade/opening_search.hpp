// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "fairway/planning/planner.hpp"

namespace fairway {

/// The place where a path that is blocked now would most probably open.
struct Opening {
  Eigen::Vector2d viewpoint = Eigen::Vector2d::Zero();   ///< the robot fits there and can reach it
  Eigen::Vector2d blocked_at = Eigen::Vector2d::Zero();  ///< the first place where it does not fit
};

/// The last places that were examined without success.
class TriedOpenings {
 public:
  static constexpr std::size_t kMost = 4;

  void add(const Eigen::Vector2d& place) noexcept {
    places_[next_] = place;
    next_ = (next_ + 1) % kMost;
    count_ = count_ < kMost ? count_ + 1 : kMost;
  }
  void clear() noexcept { count_ = next_ = 0; }
  [[nodiscard]] bool near(const Eigen::Vector2d& place) const noexcept {
    constexpr double kNear = 0.7;  // [m]
    for (std::size_t i = 0; i < count_; ++i) {
      if ((places_[i] - place).squaredNorm() < kNear * kNear) return true;
    }
    return false;
  }

 private:
  std::array<Eigen::Vector2d, kMost> places_;
  std::size_t count_ = 0;
  std::size_t next_ = 0;
};

/// Searches for the place where a path to the goal would most probably open.
///
/// The search may lead through places that are too narrow for the robot, and through obstacles, at
/// a cost. A missing centimetre of clearance costs little, an occupied cell as much as a long
/// detour. The path of least cost then leads through the gap beside a person in a door rather than
/// through the wall. It searches every second cell; deterministic.
class OpeningSearch {
 public:
  /// @param radius  Radius of the disc that covers the robot [m].
  /// @return none if the cheapest path is not blocked, or if there is none at all.
  [[nodiscard]] std::optional<Opening> find(const PreparedMap& map,
                                            const Eigen::Vector2d& position,
                                            const Eigen::Vector2d& goal,
                                            double radius,
                                            const TriedOpenings& tried);

 private:
  struct Query;
  using Entry = std::pair<float, int>;  // cost and node

  [[nodiscard]] int run(const Query& query);
  void expand(const Query& query, int node);

  std::vector<float> cost_;
  std::vector<int> before_;
  std::vector<Entry> queue_;
};

}  // namespace fairway
