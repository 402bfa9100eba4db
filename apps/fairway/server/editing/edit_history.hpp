// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fairway/map/occupancy_grid.hpp"
#include "fairway/simulation/episode_control.hpp"

namespace fairway::app {

/// A change by a user that can be undone and redone.
struct Edit {
  using Action = std::function<void(EpisodeControl&)>;

  std::string label;  ///< for users, such as "draw obstacle"
  Action undo;
  Action redo;
  std::uint64_t stroke = 0;  ///< changes with the same number are one for users; 0: none
};

/// The edits of a live world, oldest first.
class EditHistory {
 public:
  /// Number of edits that are kept; older ones are dropped.
  static constexpr std::size_t kMost = 200;

  /// Adds an edit that has just been made. Edits that were undone are dropped, and consecutive
  /// parts of one stroke are undone together.
  void add(Edit edit);

  /// Undoes the last edit. @return whether there was one.
  bool undo(EpisodeControl& control);

  /// Redoes the edit that was undone last. @return whether there was one.
  bool redo(EpisodeControl& control);

  void clear();

  /// Names of the edits that `undo` and `redo` would change; empty if there is none.
  [[nodiscard]] std::string undo_label() const;
  [[nodiscard]] std::string redo_label() const;

 private:
  std::deque<std::vector<Edit>> edits_;
  std::size_t done_ = 0;  // the first `done_` are in effect
};

}  // namespace fairway::app
