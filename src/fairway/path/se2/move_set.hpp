// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/path/se2/motion_path.hpp"

namespace fairway {

/// The moves that a search tries from every state, and how fine its states are.
struct MoveSet {
  std::vector<MotionPiece> moves;  ///< at the finest scale
  double cell = 0.05;              ///< side of a cell of states at the finest scale [m]
  int headings = 72;               ///< cells of heading in a full turn

  /// The greatest scale at which a move may be made longer: 1, 2 or 4.
  static constexpr int kMostScale = 4;
};

/// Steered bases: arcs at both gears and five steering angles. Unicycles: the same with arcs of
/// two widths, and turns on the spot. Omnidirectional bases: eight directions, turns, and
/// directions with a turn.
/// @param size  Greatest extent of the body about its reference [m]: arcs of a unicycle fit it.
[[nodiscard]] MoveSet make_moves(const BaseModel& base, double size, double cell, int headings);

}  // namespace fairway
