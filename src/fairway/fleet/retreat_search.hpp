// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fairway/fleet/retreat_path.hpp"

namespace fairway {

/// Searches for the path that find_retreat_path describes, a bounded part per control cycle.
///
/// Searches breadth first on a lattice of 0.2 m about the position at the start. The path is then
/// straightened, for one clearance after another. Other robots may move during the search: each
/// part uses those of its own cycle, and the caller checks the result with `is_still_valid`.
class RetreatSearch {
 public:
  /// Starts at `position`; forgets an earlier search.
  void begin(const Eigen::Vector2d& position, const PassingEnvironment& around) noexcept;

  void stop() noexcept { running_ = false; }
  [[nodiscard]] bool running() const noexcept { return running_; }

  /// Continues the search within the budget of a cycle. Returns the result once it is known; a path
  /// that does not exist means that there is none. @pre running.
  [[nodiscard]] std::optional<RetreatPath> advance(const PassingEnvironment& around) noexcept;

 private:
  static constexpr int kHalf = 60;  // steps to each side
  static constexpr int kSide = 2 * kHalf + 1;
  static constexpr int kStart = kHalf * kSide + kHalf;
  static constexpr std::size_t kNodes = static_cast<std::size_t>(kSide) * kSide;

  void begin_pass(const PassingEnvironment& around) noexcept;
  [[nodiscard]] bool end_pass(const PassingEnvironment& around) noexcept;
  void push(int node, std::uint8_t from) noexcept;
  [[nodiscard]] std::optional<int> expand(const PassingEnvironment& around, int& budget) noexcept;
  void follow_back(int place) noexcept;
  [[nodiscard]] bool straighten(const PassingEnvironment& around, int& budget) noexcept;
  [[nodiscard]] Eigen::Vector2d at(int node) const noexcept;
  [[nodiscard]] Eigen::Vector2d queued(int index) const noexcept;
  [[nodiscard]] bool is_clear(const PassingEnvironment& around,
                              const Eigen::Vector2d& a,
                              const Eigen::Vector2d& b,
                              int& budget) const noexcept;
  [[nodiscard]] bool can_go(const PassingEnvironment& around,
                            const Eigen::Vector2d& a,
                            const Eigen::Vector2d& b,
                            int& budget) const noexcept;
  [[nodiscard]] bool suits(const PassingEnvironment& around,
                           const Eigen::Vector2d& place) const noexcept;

  bool running_ = false;
  Eigen::Vector2d start_ = Eigen::Vector2d::Zero();
  double after_ = 0.0;         // clearance for those who follow [m]
  std::size_t pass_ = 0;       // which clearances are tried
  double more_ = 0.0;          // of this pass: beyond what those who pass need [m]
  double radius_ = 0.0;        // of this pass: of the robot with the clearance to static obstacles
  double start_radius_ = 0.0;  // the same where it leaves a start that has less
  int first_ = 0;              // of the queue
  int last_ = 0;
  int place_ = -1;  // node that was found; then the path to it is pulled straight
  int count_ = 0;   // of its nodes, which take the place of the queue
  int here_ = 0;    // the node that is looked ahead from
  int seen_ = 0;    // the furthest that is visible from there
  RetreatPath path_;
  std::array<std::uint8_t, kNodes> from_{};  // the direction that a node was found in
  std::array<std::uint16_t, kNodes> queue_{};
};

/// Finds the shortest path from `position` to a place where all robots in `passing` can pass.
///
/// The path comes no closer to the passing robots and does not pass their goals. It avoids all
/// robots that are not driving. It is empty if there is no such place within 12 m to each side.
///
/// The robot keeps 0.2 m from static obstacles or, if there is no such path, 0.1, 0.05 or 0.01 m.
/// Robots that drive in the same direction do not block the path, because they retreat too. If some
/// of them will retreat after this one, the place leaves space for them, if possible.
///
/// The search runs to its end, which takes tens of milliseconds: do not call it in a control cycle.
[[nodiscard]] RetreatPath find_retreat_path(const Eigen::Vector2d& position,
                                            const PassingEnvironment& around) noexcept;

}  // namespace fairway
