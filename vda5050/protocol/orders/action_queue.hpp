// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "protocol/messages/action.hpp"

namespace fairway::vda5050 {

/// The actions of an order, in its order: which wait, run or are done.
///
/// Actions of a node start when the node is passed, those of an edge when it is entered; the
/// blocking types decide which run together. An action takes a fixed time.
class ActionQueue {
 public:
  /// Lists actions of a node or an edge as waiting.
  /// @param sequence  sequenceId of the node or edge.
  /// @param durations  Of each action [s].
  void list(const std::vector<Action>& actions,
            const std::vector<double>& durations,
            std::uint32_t sequence,
            bool released);

  /// Drops waiting actions that belong to the horizon.
  void drop_horizon();

  /// Forgets all actions.
  void clear() { entries_.clear(); }

  /// Lets the actions of a node or edge start as soon as the blocking types allow.
  void enter(std::uint32_t sequence);

  /// Ends the actions of an edge that the vehicle leaves: running ones finish, waiting ones fail.
  void leave(std::uint32_t sequence);

  /// Fails what waits; what runs continues.
  void cancel();

  /// Ends actions whose time is over and starts those whose turn it is.
  /// @return whether any status changed.
  bool update(double now);

  /// Returns whether an action that forbids driving runs, or waits for its turn.
  [[nodiscard]] bool forbids_driving() const;

  /// Returns whether a node has an action that forbids driving.
  [[nodiscard]] bool will_stop_at(std::uint32_t sequence) const;

  [[nodiscard]] bool running() const;
  [[nodiscard]] bool all_done() const;
  [[nodiscard]] std::vector<ActionState> states() const;

 private:
  struct Entry {
    ActionState state;
    BlockingType blocking = BlockingType::None;
    double duration = 0.0;
    double end = 0.0;
    std::uint32_t sequence = 0;
    bool released = false;
    bool entered = false;
  };

  std::vector<Entry> entries_;
  bool changed_ = false;
};

}  // namespace fairway::vda5050
