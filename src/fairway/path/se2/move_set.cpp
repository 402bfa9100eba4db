// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/se2/move_set.hpp"

#include <cmath>
#include <numbers>

#include "fairway/path/se2/connections.hpp"

namespace fairway {

namespace {

// Long enough to leave a cell in any direction.
double stride(double cell) noexcept { return 1.6 * cell; }

void add_arcs(const std::vector<double>& curvatures, MoveSet& set) {
  for (const double gear : {1.0, -1.0}) {
    for (const double curvature : curvatures)
      set.moves.push_back(
          {.twist = {.linear = gear, .angular = gear * curvature}, .amount = stride(set.cell)});
  }
}

void add_turns(MoveSet& set) {
  const double angle = 1.05 * 2.0 * std::numbers::pi / set.headings;
  for (const double side : {1.0, -1.0})
    set.moves.push_back({.twist = {.angular = side}, .amount = angle});
}

}  // namespace

MoveSet make_moves(const BaseModel& base, double size, double cell, int headings) {
  MoveSet set;
  set.cell = cell;
  set.headings = headings;
  if (is_steered(base)) {
    const double most = search_curvature(base);
    add_arcs({0.0, 0.5 * most, -0.5 * most, most, -most}, set);
  } else if (base.kind == BaseKind::Unicycle) {
    const double wide = 0.5 / size;
    const double tight = 1.5 / size;
    add_arcs({0.0, wide, -wide, tight, -tight}, set);
    add_turns(set);
  } else {
    const double tight = 1.2 / size;
    for (int k = 0; k < 8; ++k) {
      const double angle = k * std::numbers::pi / 4.0;
      const PlanarTwist line{.linear = std::cos(angle), .lateral = std::sin(angle)};
      for (const double turn : {0.0, tight, -tight}) {
        set.moves.push_back({.twist = {line.linear, line.lateral, turn}, .amount = stride(cell)});
      }
    }
    add_turns(set);
  }
  std::erase_if(set.moves, [&](const MotionPiece& move) {
    return !std::isfinite(speed_load(base, move.twist));
  });
  return set;
}

}  // namespace fairway
