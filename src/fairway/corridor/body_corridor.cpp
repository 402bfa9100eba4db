// SPDX-License-Identifier: Apache-2.0
#include "fairway/corridor/body_corridor.hpp"

#include <algorithm>

#include "fairway/corridor/rectangle/largest_rectangle.hpp"

namespace fairway {

using Eigen::Vector2d;

SlicedBody SlicedBody::of(const Vector2d& low, const Vector2d& high) noexcept {
  const Vector2d middle = 0.5 * (low + high);
  if (high.x() - low.x() >= high.y() - low.y()) {
    return {{low, Vector2d(low.x(), high.y()), Vector2d(middle.x(), low.y()),
             Vector2d(middle.x(), high.y()), Vector2d(high.x(), low.y()), high}};
  }
  return {{low, Vector2d(high.x(), low.y()), Vector2d(low.x(), middle.y()),
           Vector2d(high.x(), middle.y()), Vector2d(low.x(), high.y()), high}};
}

std::optional<BodyCorridor::Pair> BodyCorridor::at(int pose) const noexcept {
  struct Best {
    int depth = -1;
    std::size_t link = 0;
    void look(int d, std::size_t i) noexcept {
      if (d <= depth) return;
      depth = d;
      link = i;
    }
  };
  Best whole;
  std::array<Best, 2> parts;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::array<int, 2> depth{links[i].parts[0].depth(pose), links[i].parts[1].depth(pose)};
    whole.look(std::min(depth[0], depth[1]), i);
    for (std::size_t part = 0; part < 2; ++part)
      parts[part].look(depth[part], i);
  }
  if (whole.depth >= 0) return Pair{whole.link, whole.link};
  if (parts[0].depth < 0 || parts[1].depth < 0) return std::nullopt;
  return Pair{parts[0].link, parts[1].link};
}

namespace {

// Poses of each part that one rectangle is to contain: as BodyCorridor::Range.
using Ranges = std::array<BodyCorridor::Range, 2>;

class BodyCorridorSearch {
 public:
  BodyCorridorSearch(const BitGrid& obstacles,
                     const SlicedBody& body,
                     std::span<const Pose2> poses,
                     double margin)
      : obstacles_(obstacles),
        body_(body),
        poses_(poses),
        margin_(margin) {
    settings_.longest_side = kLongestSide;
    settings_.num_orientations = kOrientations;
    settings_.refinements = kRefinements;
  }

  BodyCorridor run() {
    BodyCorridor corridor;
    most_ = static_cast<int>(poses_.size()) - 1;
    std::array<int, 2> start{0, 0};
    while (std::max(start[0], start[1]) <= most_) {
      const int last = furthest_whole(start);
      if (last < std::max(start[0], start[1])) {
        // No free rectangle contains the box here.
        start.fill(std::max(start[0], start[1]) + 1);
        continue;
      }
      std::array<int, 2> next{last, last};
      if (last < most_) next = next_start(start, last);
      add(ranges_of(start, next), corridor);
      if (last == most_) break;
      // A rectangle that ends where it begins is of no use at the next pose.
      if (next == start) next.fill(last + 1);
      start = next;
    }
    return corridor;
  }

 private:
  static constexpr double kLongestSide = 10.0;  // [m]
  static constexpr int kOrientations = 12;
  static constexpr int kRefinements = 2;
  static constexpr int kLong = 10;  // poses of a link after which it needs no slices

  [[nodiscard]] static Ranges ranges_of(const std::array<int, 2>& first,
                                        const std::array<int, 2>& last) {
    return {{{first[0], last[0]}, {first[1], last[1]}}};
  }

  // The last pose up to which one rectangle contains both parts.
  int furthest_whole(const std::array<int, 2>& start) {
    return furthest(std::max(start[0], start[1]), most_, [&](int to) {
      return ranges_of(start, {to, to});
    });
  }

  // The poses at which the parts enter the link after one that contains both up to `last`. Where
  // that link would be short, the trailing part stays as long as both links have space for that.
  std::array<int, 2> next_start(const std::array<int, 2>& start, int last) {
    const std::array<int, 2> whole{last, last};
    const int reached = furthest_whole(whole);
    if (reached >= std::min(most_, last + kLong)) return whole;
    const std::size_t trailing = 1 - leading_part(last);
    const auto staying = [&](int to) {
      std::array<int, 2> starts = whole;
      starts[trailing] = to;
      return starts;
    };
    int stays = furthest(last, most_, [&](int to) { return ranges_of(start, staying(to)); });
    if (stays <= last) return whole;
    stays = furthest(last, stays, [&](int to) { return ranges_of(staying(to), {to, to}); });
    if (stays <= last || furthest_whole(staying(stays)) <= reached) return whole;
    return staying(stays);
  }

  // The part of the body that is ahead in the direction of motion.
  [[nodiscard]] std::size_t leading_part(int pose) const {
    const auto k = static_cast<std::size_t>(pose);
    const Pose2& now = poses_[k];
    const Pose2& next = poses_[std::min(k + 1, poses_.size() - 1)];
    const Vector2d move = inverse_transform(now, next.position);
    const Vector2d axis = body_.points[4] - body_.points[0];
    return move.dot(axis) >= 0.0 ? 1 : 0;
  }

  // The last pose to which one rectangle contains the ranges; less than `first` for none.
  template <typename RangesTo>
  int furthest(int first, int most, const RangesTo& ranges_to) {
    int good = first - 1;
    int step = 1;
    while (good + step <= most && find(ranges_to(good + step))) {
      good += step;
      step *= 2;
    }
    int bad = std::min(most + 1, good + step);
    while (bad - good > 1) {
      const int middle = (good + bad) / 2;
      (find(ranges_to(middle)) ? good : bad) = middle;
    }
    return good;
  }

  bool find(const Ranges& ranges) {
    found_ = search(ranges, margin_);
    if (!found_) found_ = search(ranges, 0.0);
    return found_.has_value();
  }

  std::optional<RectangleSearch::Found> search(const Ranges& ranges, double margin) {
    const GridFrame& grid = obstacles_.frame();
    anchors_.clear();
    const auto middle = static_cast<std::size_t>((ranges[0].first + ranges[0].last) / 2);
    const Vector2d inside = 0.5 * (body_.points[2] + body_.points[3]);
    anchors_.push_back({.point = grid.to_grid(transform(poses_[middle], inside)), .margin = 0.0});
    for (std::size_t part = 0; part < 2; ++part) {
      for (int k = ranges[part].first; k <= ranges[part].last; ++k) {
        for (const Vector2d& point : body_.part(part)) {
          const Vector2d at = transform(poses_[static_cast<std::size_t>(k)], point);
          anchors_.push_back({.point = grid.to_grid(at), .margin = margin / grid.resolution});
        }
      }
    }
    return search_.find(obstacles_, 0.0, anchors_, settings_,
                        poses_[middle].heading - grid.origin.heading);
  }

  // Adds the rectangle for these ranges, with all the poses before and after that it contains.
  void add(const Ranges& ranges, BodyCorridor& corridor) {
    if (!find(ranges)) return;
    BodyCorridor::Link link{.rectangle = to_world(obstacles_.frame(), found_->frame, found_->box),
                            .parts = ranges};
    if (!is_free(obstacles_, link.rectangle, 0.0)) return;
    for (std::size_t part = 0; part < 2; ++part) {
      BodyCorridor::Range& range = link.parts[part];
      while (range.first > 0 && holds(link.rectangle, part, range.first - 1))
        --range.first;
      while (range.last + 1 < static_cast<int>(poses_.size()) &&
             holds(link.rectangle, part, range.last + 1))
        ++range.last;
    }
    corridor.links.push_back(link);
  }

  [[nodiscard]] bool holds(const OrientedRectangle& rectangle, std::size_t part, int pose) const {
    const auto points = body_.part(part);
    return std::all_of(points.begin(), points.end(), [&](const Vector2d& point) {
      return rectangle.contains(transform(poses_[static_cast<std::size_t>(pose)], point), -margin_);
    });
  }

  const BitGrid& obstacles_;
  const SlicedBody& body_;
  std::span<const Pose2> poses_;
  double margin_;
  int most_ = 0;  // the last pose
  RectangleSearchSettings settings_;
  RectangleSearch search_;
  std::vector<Anchor> anchors_;
  std::optional<RectangleSearch::Found> found_;
};

}  // namespace

BodyCorridor build_body_corridor(const BitGrid& obstacles,
                                 const SlicedBody& body,
                                 std::span<const Pose2> poses,
                                 double margin) {
  return BodyCorridorSearch(obstacles, body, poses, margin).run();
}

}  // namespace fairway
