// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/simulation/world.hpp"

namespace fairway {

/// What can be changed in a run between two cycles, by someone who plays with it.
class EpisodeControl {
 public:
  EpisodeControl() = default;
  EpisodeControl(const EpisodeControl&) = delete;
  EpisodeControl& operator=(const EpisodeControl&) = delete;
  virtual ~EpisodeControl() = default;

  [[nodiscard]] virtual const World& world() const = 0;

  /// Sends a robot somewhere else. One that has collided stays where it is. @pre robot exists.
  virtual void set_goal(std::size_t robot, const Goal& goal) = 0;

  /// Makes cells obstacles, or free. Cells outside the map are skipped, and cells that a robot
  /// stands on are not made obstacles. Every robot under way gets a new plan.
  virtual void set_cells(std::span<const CellIndex> cells, bool blocked) = 0;

  /// Gives a body another way to go; index `world().num_bodies()` adds it.
  virtual void set_body(std::size_t index, const MovingBody& body) = 0;

  /// Takes a body away; those behind it move up. @pre it exists.
  virtual void remove_body(std::size_t index) = 0;

  /// Drives on with other settings. @pre validate(settings) holds.
  virtual void set_settings(const Settings& settings) = 0;
};

}  // namespace fairway
