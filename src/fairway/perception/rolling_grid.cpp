// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/rolling_grid.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/map/grid_traversal.hpp"
#include "fairway/perception/beam_coverage.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr int kWordBits = 64;
static_assert(RollingGrid::kBlock == kWordBits);

// Rounds the window up to an odd number of blocks, so that the robot's block can be the middle one.
int side_in_cells(const PerceptionSettings& settings) {
  const auto blocks =
      static_cast<int>(std::ceil(settings.window / (settings.resolution * RollingGrid::kBlock)));
  return (blocks | 1) * RollingGrid::kBlock;
}

GridFrame window_around(const Vector2d& center, int side, double resolution) {
  // The window is aligned to whole blocks of the world, so that a revisited place has the same
  // cells.
  const double block = resolution * RollingGrid::kBlock;
  const double half = 0.5 * (side / RollingGrid::kBlock - 1);
  const auto low = [&](double c) { return (std::floor(c / block) - half) * block; };
  return {.width = side,
          .height = side,
          .resolution = resolution,
          .origin = {.position = {low(center.x()), low(center.y())}, .heading = 0.0}};
}

// Clips a segment to the part strictly inside the grid, in grid coordinates (Liang-Barsky).
bool clip(const GridFrame& frame, Vector2d& from, Vector2d& to) noexcept {
  constexpr double kInside = 1e-6;  // [cells]
  const Vector2d start = from;
  const Vector2d segment = to - from;
  double first = 0.0;
  double last = 1.0;
  const double limit[2] = {frame.width - kInside, frame.height - kInside};
  for (int axis = 0; axis < 2; ++axis) {
    const double enter = kInside - start[axis];
    const double leave = limit[axis] - start[axis];
    if (std::abs(segment[axis]) < 1e-12) {
      if (enter > 0.0 || leave < 0.0) return false;
      continue;
    }
    const double a = enter / segment[axis];
    const double b = leave / segment[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first <= last)) return false;
  from = start + first * segment;
  to = start + last * segment;
  return true;
}

}  // namespace

RollingGrid::RollingGrid(const PerceptionSettings& settings, const Vector2d& center)
    : settings_(settings),
      side_(side_in_cells(settings)),
      cells_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_),
             Cell{.evidence = 0, .newness = 0, .scan = kNever}),
      surely_free_(cells_.size() / kBlock, 0),
      occupied_(window_around(center, side_, settings.resolution), false),
      not_seen_free_(occupied_.frame(), true) {}

CellState RollingGrid::at(CellIndex cell) const noexcept {
  if (!frame().contains(cell) || cell_of(cell).scan == kNever) return CellState::Unknown;
  return cell_of(cell).evidence > 0 ? CellState::Occupied : CellState::Free;
}

bool RollingGrid::would_be_new(CellIndex cell) const noexcept {
  if (!frame().contains(cell)) return false;
  const std::uint8_t newness = cell_of(cell).newness;
  return newness > 0 && newness < kUnproven;
}

bool RollingGrid::is_static_near(CellIndex cell, int reach) const noexcept {
  for (int y = std::max(0, cell.y - reach); y <= std::min(side_ - 1, cell.y + reach); ++y) {
    for (int x = std::max(0, cell.x - reach); x <= std::min(side_ - 1, cell.x + reach); ++x) {
      const Cell& value = cell_of({.x = x, .y = y});
      const bool never_free = value.newness == 0 || value.newness >= kUnproven;
      if (value.scan != kNever && value.evidence > 0 && never_free) return true;
    }
  }
  return false;
}

bool RollingGrid::is_proven_static(CellIndex cell) const noexcept {
  for (int y = std::max(0, cell.y - 1); y <= std::min(side_ - 1, cell.y + 1); ++y) {
    for (int x = std::max(0, cell.x - 1); x <= std::min(side_ - 1, cell.x + 1); ++x) {
      const Cell& value = cell_of({.x = x, .y = y});
      const bool proven = value.newness == 0 || value.newness == kUnproven;
      if (value.scan != kNever && value.evidence > 0 && proven) return true;
    }
  }
  return false;
}

void RollingGrid::insert(std::span<const Beam> beams,
                         const Vector2d& robot,
                         double body_radius) noexcept {
  follow(robot);
  next_scan();
  changed_ = {.first = {.x = side_, .y = side_}, .last = {.x = -1, .y = -1}};
  for (const Beam& beam : beams) {
    if (beam.end == BeamEnd::Hit && !beam.moving) mark(beam);
  }
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (beams[i].end != BeamEnd::Nothing)
      clear(beams[i], covered_by_neighbours(beams, i, settings_.resolution));
  }
  claim_body(robot, body_radius);
}

void RollingGrid::follow(const Vector2d& robot) noexcept {
  // The window moves once the robot is a quarter block outside of the middle one. It does not move
  // repeatedly when the robot moves back and forth over an edge.
  const Vector2d cell = frame().to_grid(robot);
  const double middle = 0.5 * (side_ - kBlock);
  const auto blocks = [&](double c) {
    const double off = (c - middle) / kBlock;  // 0..1 in the middle block
    return off < -0.25 || off > 1.25 ? static_cast<int>(std::floor(off)) : 0;
  };
  const bool known = std::abs(cell.x()) < 1e8 && std::abs(cell.y()) < 1e8;
  const int x = known ? blocks(cell.x()) : 0;
  const int y = known ? blocks(cell.y()) : 0;
  rolled_ = x != 0 || y != 0;
  if (rolled_) roll(x, y);
}

void RollingGrid::roll(int blocks_x, int blocks_y) noexcept {
  const int all = side_ / kBlock;
  const int dx = std::clamp(blocks_x, -all, all);
  const int rows = std::clamp(blocks_y, -all, all) * kBlock;
  const auto kept = static_cast<std::size_t>(all - std::abs(dx));  // blocks kept in a row
  // Moves a row by `dx` blocks and fills the rest; `unit` elements make a block.
  const auto move_row = [&](auto* to, const auto* from, std::size_t unit, auto fill) {
    const auto shift = static_cast<std::size_t>(std::abs(dx)) * unit;
    const std::size_t stay = kept * unit;
    if (from == nullptr) {
      std::fill_n(to, stay + shift, fill);
    } else if (dx >= 0) {
      std::copy(from + shift, from + shift + stay, to);
      std::fill_n(to + stay, shift, fill);
    } else {
      std::copy_backward(from, from + stay, to + shift + stay);
      std::fill_n(to, shift, fill);
    }
  };
  // target(y) and source(y) return the elements of a row.
  const auto move_rows = [&](const auto& target, const auto& source, std::size_t unit, auto fill) {
    for (int n = 0; n < side_; ++n) {
      const int y = rows >= 0 ? n : side_ - 1 - n;  // no row is overwritten before it is moved
      const int from = y + rows;
      const bool known = from >= 0 && from < side_;
      move_row(target(y), known ? source(from) : nullptr, unit, fill);
    }
  };
  const auto cells_of = [&](int y) {
    return cells_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(side_);
  };
  move_rows(cells_of, cells_of, kBlock, Cell{.evidence = 0, .newness = 0, .scan = kNever});
  const auto free_of = [&](int y) { return surely_free_.data() + word_of({.x = 0, .y = y}); };
  move_rows(free_of, free_of, 1, std::uint64_t{0});
  const auto move_bits = [&](BitGrid& grid, std::uint64_t fill) {
    grid.rewrite([&](const auto& words_of_row) {
      move_rows([&](int y) { return words_of_row(y).data(); },
                [&](int y) { return grid.row(y).data(); }, 1, fill);
    });
  };
  move_bits(occupied_, std::uint64_t{0});
  move_bits(not_seen_free_, ~std::uint64_t{0});
  Pose2 origin = frame().origin;
  const double block = settings_.resolution * kBlock;
  // Computed from the number of blocks, not accumulated, so that a place always has the same cells.
  origin.position.x() = (std::round(origin.position.x() / block) + blocks_x) * block;
  origin.position.y() = (std::round(origin.position.y() / block) + blocks_y) * block;
  occupied_.move_to(origin);
  not_seen_free_.move_to(origin);
}

void RollingGrid::next_scan() noexcept {
  if (++scan_ < kNever) return;
  // The numbers have run out: those of the older half become 0, the others keep their order.
  constexpr std::uint16_t kHalf = kNever / 2;
  scan_ = static_cast<std::uint16_t>(scan_ - kHalf);
  for (Cell& cell : cells_) {
    if (cell.scan == kNever) continue;
    cell.scan = cell.scan > kHalf ? static_cast<std::uint16_t>(cell.scan - kHalf) : 0;
  }
}

void RollingGrid::add(CellIndex cell, Cell& value, int evidence) noexcept {
  const bool known = value.scan != kNever;
  const bool was_occupied = known && value.evidence > 0;
  const bool was_blocked = occupied_.blocked(cell);  // not where it was doubted
  value.scan = scan_;
  value.evidence = static_cast<std::int8_t>(
      std::clamp(value.evidence + evidence, settings_.least_evidence, settings_.most_evidence));
  const bool is_occupied = value.evidence > 0;
  const std::uint64_t bit = std::uint64_t{1} << (cell.x % kBlock);
  std::uint64_t& free = surely_free_[word_of(cell)];
  free = value.evidence == settings_.least_evidence ? free | bit : free & ~bit;
  if (2 * value.evidence <= settings_.least_evidence) {
    value.newness = kNewScans;
  } else if (evidence > 0 && value.newness == 0) {
    if (!was_occupied) value.newness = kUnproven + kProofScans;
  } else if (evidence > 0 && value.newness != kUnproven) {
    --value.newness;
  }
  if (!known || is_occupied != was_occupied) not_seen_free_.set(cell, is_occupied);
  if (is_occupied == was_blocked) return;
  occupied_.set(cell, is_occupied);
  include(changed_, cell);
}

CellWindow RollingGrid::doubt_unseen(int scans) noexcept {
  CellWindow doubted{.first = {.x = side_, .y = side_}, .last = {.x = -1, .y = -1}};
  for (int y = 0; y < side_; ++y) {
    for (int x = occupied_.first_blocked(y, 0, side_ - 1); x >= 0;
         x = occupied_.first_blocked(y, x + 1, side_ - 1)) {
      const CellIndex cell{.x = x, .y = y};
      if (scan_ - cell_of(cell).scan < scans) continue;
      occupied_.set(cell, false);
      include(doubted, cell);
    }
  }
  return doubted;
}

void RollingGrid::mark(const Beam& beam) noexcept {
  const Vector2d ray = beam.to - beam.from;
  const double length = ray.norm();
  if (!(length > 0.0)) return;
  // A cell extends in front of the hit by half a side on average, and range errors add to that. A
  // small offset keeps narrow gaps open.
  const Vector2d along = ray / length;
  CellIndex cell = frame().cell_at(beam.to + settings_.hit_depth * along);
  // Range errors in front of a known surface would form a layer of false cells.
  const CellIndex behind =
      frame().cell_at(beam.to + (settings_.hit_depth + settings_.hit_snap) * along);
  if (behind != cell && at(behind) == CellState::Occupied && at(cell) != CellState::Occupied) {
    cell = behind;
  }
  if (!frame().contains(cell)) return;
  Cell& value = cell_of(cell);
  if (value.scan != scan_) add(cell, value, settings_.hit_evidence);
}

void RollingGrid::clear(const Beam& beam, double known) noexcept {
  const Vector2d ray = beam.to - beam.from;
  const double length = ray.norm();
  if (known >= length) return;
  Vector2d from = frame().to_grid(beam.from + known / length * ray);
  Vector2d to = frame().to_grid(beam.to);
  if (!clip(frame(), from, to)) return;
  // Under a moving object there may be anything, such as the wall beside its path.
  const CellIndex covered = beam.moving && beam.end == BeamEnd::Hit ? frame().cell_at(beam.to)
                                                                    : CellIndex{.x = -1, .y = -1};
  walk_cells(from, to, [this, covered](CellIndex cell, double) {
    if (is_surely_free(cell)) return true;
    Cell& value = cell_of(cell);
    if (cell == covered && value.scan == kNever) return true;
    // Cells that were hit already have this scan's number.
    if (value.scan != scan_) add(cell, value, -settings_.miss_evidence);
    return true;
  });
}

void RollingGrid::claim_body(const Vector2d& robot, double radius) noexcept {
  const double reach = radius / settings_.resolution + 1.5;  // [cells], to the centres
  const Vector2d center = frame().to_grid(robot);
  const auto low = [&](double c) { return std::max(0, static_cast<int>(std::floor(c - reach))); };
  const auto high = [&](double c) {
    return std::min(side_ - 1, static_cast<int>(std::floor(c + reach)));
  };
  if (!is_finite(center) || center.cwiseAbs().maxCoeff() > 1e8) return;
  for (int y = low(center.y()); y <= high(center.y()); ++y) {
    for (int x = low(center.x()); x <= high(center.x()); ++x) {
      const double away = (Vector2d(x + 0.5, y + 0.5) - center).norm();
      Cell& value = cell_of({.x = x, .y = y});
      if (away <= reach && value.scan == kNever) add({.x = x, .y = y}, value, 0);
    }
  }
}

}  // namespace fairway
