// SPDX-License-Identifier: Apache-2.0
#include "fairway/fleet/retreat_path.hpp"

#include <algorithm>
#include <cstdint>

#include "fairway/map/free_space.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kLatticeSpacing = 0.2;  // [m] between neighbouring nodes of the lattice
constexpr int kHalf = 60;                // number of steps to each side
constexpr int kSide = 2 * kHalf + 1;
constexpr double kLeast = 0.01;  // [m] between the body and static obstacles
constexpr double kBody = 0.05;   // [m] between bodies

// A breadth-first search over the lattice; each node stores the direction from which it was
// reached.
class Search {
 public:
  // @param clearance  Distance between the body and static obstacles [m].
  // @param more  Additional distance between the place and the passing robots [m].
  Search(const Vector2d& start,
         const PassingEnvironment& around,
         double clearance,
         double more) noexcept
      : start_(start),
        around_(around),
        more_(more),
        radius_(around.radius + clearance),
        // A start with less clearance must still be able to leave.
        start_radius_(std::min(
            radius_,
            distance_to_blocked(*around.obstacles, start, radius_) - 2.0 * kFreeSpaceSkin)) {
    from_.fill(kUnseen);
  }

  // Returns the path from the start to the nearest suitable place; empty if there is none.
  [[nodiscard]] RetreatPath run() noexcept {
    if (start_radius_ < around_.radius) return {};
    int last = 0;
    push(kStart, kStartMark, last);
    for (int first = 0; first < last; ++first) {
      const int node = queue_[static_cast<std::size_t>(first)];
      if (node != kStart && suits(at(node))) return straightened(node);
      for (std::size_t d = 0; d < kDirections.size(); ++d) {
        const auto [dx, dy] = kDirections[d];
        const int x = node % kSide + dx;
        const int y = node / kSide + dy;
        if (x < 0 || y < 0 || x >= kSide || y >= kSide) continue;
        const int next = y * kSide + x;
        if (from_[static_cast<std::size_t>(next)] == kUnseen && can_go(node, next))
          push(next, static_cast<std::uint8_t>(d), last);
      }
    }
    return {};
  }

 private:
  struct Direction {
    int x;
    int y;
  };
  static constexpr std::array<Direction, 8> kDirections{{{.x = 1, .y = 0},
                                                         {.x = 0, .y = 1},
                                                         {.x = -1, .y = 0},
                                                         {.x = 0, .y = -1},
                                                         {.x = 1, .y = 1},
                                                         {.x = -1, .y = 1},
                                                         {.x = -1, .y = -1},
                                                         {.x = 1, .y = -1}}};
  static constexpr int kStart = kHalf * kSide + kHalf;
  static constexpr std::uint8_t kUnseen = 255;
  static constexpr std::uint8_t kStartMark = 254;

  void push(int node, std::uint8_t from, int& last) noexcept {
    from_[static_cast<std::size_t>(node)] = from;
    queue_[static_cast<std::size_t>(last++)] = static_cast<std::uint16_t>(node);
  }

  [[nodiscard]] Vector2d at(int node) const noexcept {
    return start_ + kLatticeSpacing * Vector2d(node % kSide - kHalf, node / kSide - kHalf);
  }

  [[nodiscard]] bool is_clear(const Vector2d& a, const Vector2d& b) const noexcept {
    const bool leaves = a == start_;
    return is_free(*around_.obstacles, a, b, leaves ? start_radius_ : radius_);
  }

  [[nodiscard]] bool can_go(int node, int next) const noexcept {
    const Vector2d a = at(node);
    const Vector2d b = at(next);
    for (const FleetMember& member : around_.fleet) {
      const SharedMotion& other = *member.motion;
      if (other.under_way && !around_.must_yield_to(other)) continue;
      const double before = (a - other.position).norm();
      const double after = (b - other.position).norm();
      if (after < around_.radius + other.radius + kBody && after < before) return false;
    }
    const bool past =
        std::any_of(around_.passing.begin(), around_.passing.end(), [&](const SharedMotion* other) {
          return other != nullptr && passes_goal_of(*other, a, b, around_.radius);
        });
    return !past && is_clear(a, b);
  }

  [[nodiscard]] bool suits(const Vector2d& place) const noexcept {
    for (const FleetMember& member : around_.fleet) {
      const double apart = (member.motion->position - place).norm();
      if (apart < around_.radius + member.motion->radius + kBody) return false;
    }
    return std::all_of(around_.passing.begin(), around_.passing.end(),
                       [&](const SharedMotion* other) {
                         return other == nullptr || lets_pass(place, *other, around_.radius, more_);
                       });
  }

  // Follows the nodes back from the place to the start, and connects each point to the furthest
  // visible one.
  [[nodiscard]] RetreatPath straightened(int place) noexcept {
    int count = 0;  // the nodes of the path overwrite the queue
    for (int node = place;; node = before(node)) {
      queue_[static_cast<std::size_t>(count++)] = static_cast<std::uint16_t>(node);
      if (node == kStart) break;
    }
    std::reverse(queue_.begin(), queue_.begin() + count);
    RetreatPath path;
    for (int here = 0; here + 1 < count && path.count < RetreatPath::kMaxPoints;) {
      int next = here + 1;
      const auto point = [&](int i) { return at(queue_[static_cast<std::size_t>(i)]); };
      while (next + 1 < count && is_clear(point(here), point(next + 1)))
        ++next;
      path.points[static_cast<std::size_t>(path.count++)] = point(next);
      here = next;
    }
    return path.place() == at(place) ? path : RetreatPath{};
  }

  [[nodiscard]] int before(int node) const noexcept {
    const auto [dx, dy] = kDirections[from_[static_cast<std::size_t>(node)]];
    return node - dy * kSide - dx;
  }

  Vector2d start_;
  const PassingEnvironment& around_;
  double more_;
  double radius_;
  double start_radius_;
  std::array<std::uint8_t, static_cast<std::size_t>(kSide) * kSide> from_;
  std::array<std::uint16_t, static_cast<std::size_t>(kSide) * kSide> queue_;
};

// Returns the space that other robots need before the place: those between this robot and a passing
// one, which will retreat after this robot.
double space_for_followers(const Vector2d& position, const PassingEnvironment& around) noexcept {
  double space = 0.0;
  for (const FleetMember& member : around.fleet) {
    const SharedMotion& other = *member.motion;
    if (around.must_yield_to(other) || !other.under_way || other.can_step_aside) continue;
    const bool between =
        std::any_of(around.passing.begin(), around.passing.end(), [&](const SharedMotion* passing) {
          return passing != nullptr && (passing->position - other.position).norm() <
                                           (passing->position - position).norm();
        });
    if (between) space += 2.0 * other.radius + kBody;
  }
  return space;
}

}  // namespace

double RetreatPath::length(const Vector2d& position) const noexcept {
  if (!exists()) return std::numeric_limits<double>::infinity();
  double sum = 0.0;
  Vector2d from = position;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    sum += (points[i] - from).norm();
    from = points[i];
  }
  return sum;
}

RetreatPath find_retreat_path(const Vector2d& position, const PassingEnvironment& around) noexcept {
  const double after = space_for_followers(position, around);
  for (const double clearance : {0.2, 0.1, 0.05, kLeast}) {
    for (const double more : {after, 0.0}) {
      if (const RetreatPath path = Search(position, around, clearance, more).run(); path.exists())
        return path;
      if (after == 0.0) break;
    }
  }
  return {};
}

void shorten(RetreatPath& path,
             const Vector2d& position,
             const BitGrid& obstacles,
             double radius) noexcept {
  int seen = path.count - 1;
  while (seen > 0 && !is_free(obstacles, position, path.points[static_cast<std::size_t>(seen)],
                              radius + kLeast)) {
    --seen;
  }
  if (seen <= 0) return;
  std::copy(path.points.begin() + seen, path.points.begin() + path.count, path.points.begin());
  path.count -= seen;
}

bool is_still_valid(const RetreatPath& path,
                    const Vector2d& position,
                    const PassingEnvironment& around) noexcept {
  if (!path.exists()) return false;
  const auto lets = [&](const SharedMotion* other) {
    return other == nullptr || lets_pass(path.place(), *other, around.radius);
  };
  if (!std::all_of(around.passing.begin(), around.passing.end(), lets)) return false;
  Vector2d from = position;
  for (std::size_t i = 0; i < static_cast<std::size_t>(path.count); ++i) {
    if (!is_free(*around.obstacles, from, path.points[i], around.radius)) return false;
    from = path.points[i];
  }
  return true;
}

}  // namespace fairway
