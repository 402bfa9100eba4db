// SPDX-License-Identifier: Apache-2.0
#include "fairway/path/se2/shortcuts.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/map/body_zones.hpp"
#include "fairway/path/se2/connections.hpp"

namespace fairway {

namespace {

// The path cut into pieces of at most `most` [m or rad], with the pose at every cut.
struct CutPath {
  std::vector<MotionPiece> pieces;
  std::vector<Pose2> poses;

  CutPath(const MotionPath& path, double most) {
    poses.push_back(path.start);
    for (const MotionPiece& piece : path.pieces) {
      const int count = std::max(1, static_cast<int>(std::ceil(piece.amount / most)));
      for (int i = 0; i < count; ++i) {
        pieces.push_back({.twist = piece.twist, .amount = piece.amount / count});
        poses.push_back(pieces.back().from(poses.back()));
      }
    }
  }
};

bool is_free(const BodyClearance& clearance,
             const Pose2& start,
             const std::vector<MotionPiece>& pieces,
             double margin) noexcept {
  Pose2 pose = start;
  for (const MotionPiece& piece : pieces) {
    const ZoneMap* const zones = clearance.obstacles().zones();
    if (zones != nullptr && internal::goes_against_lane(*zones, pose, piece.twist, piece.amount,
                                                        internal::kPlannedLanes))
      return false;
    if (!clearance.is_free(pose, piece.twist, piece.amount, margin)) return false;
    pose = piece.from(pose);
  }
  return true;
}

// The path with pieces first to last - 1 replaced.
MotionPath replaced(const CutPath& cut,
                    const Pose2& start,
                    std::size_t first,
                    std::size_t last,
                    const std::vector<MotionPiece>& between) {
  MotionPath path{.start = start, .pieces = {}};
  const auto at = [&](std::size_t i) {
    return cut.pieces.begin() + static_cast<std::ptrdiff_t>(i);
  };
  path.pieces.assign(cut.pieces.begin(), at(first));
  path.pieces.insert(path.pieces.end(), between.begin(), between.end());
  path.pieces.insert(path.pieces.end(), at(last), cut.pieces.end());
  merge_pieces(path);
  return path;
}

}  // namespace

void take_shortcuts(const BodyClearance& clearance,
                    const MotionCost& cost,
                    double margin,
                    int tries,
                    MotionPath& path) {
  // A shortcut may lead through a zone that the search avoided for its cost.
  const ZoneMap* const zones = clearance.obstacles().zones();
  if (zones != nullptr && zones->greatest_cost() > 0.0) return;
  constexpr double kCutsPerPath = 24.0;
  std::vector<Connection> connections;
  double now = cost.of(path.pieces);
  double total = 0.0;
  for (const MotionPiece& piece : path.pieces)
    total += piece.amount;
  std::uint64_t random = 0x2545F4914F6CDD1DULL;  // xorshift, always from the same seed
  CutPath cut(path, std::max(0.05, total / kCutsPerPath));
  for (int i = 0; i < tries; ++i) {
    random ^= random << 13U;
    random ^= random >> 7U;
    random ^= random << 17U;
    const std::size_t count = cut.poses.size();
    if (count < 3) return;
    std::size_t first = (random >> 8U) % count;
    std::size_t last = (random >> 36U) % count;
    if (first > last) std::swap(first, last);
    if (last - first < 2) continue;
    find_connections(cost, cut.poses[first], cut.poses[last], connections);
    for (std::size_t c = 0; c < std::min<std::size_t>(4, connections.size()); ++c) {
      MotionPath next = replaced(cut, path.start, first, last, connections[c].pieces);
      const double better = cost.of(next.pieces);
      if (better >= now - 1e-3) continue;
      if (!is_free(clearance, cut.poses[first], connections[c].pieces, margin)) continue;
      path = std::move(next);
      now = better;
      cut = CutPath(path, std::max(0.05, total / kCutsPerPath));
      break;
    }
  }
}

}  // namespace fairway
