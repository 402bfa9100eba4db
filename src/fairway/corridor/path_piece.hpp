// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/corridor/path_track.hpp"
#include "fairway/corridor/rectangle/turned_frame.hpp"

namespace fairway {

/// The region that two consecutive rectangles share. Lengths are in cells.
///
/// Both rectangles contain the path from `from` to `to` with `margin` to every side. They share at
/// least a disc of that radius, swept along that part. With an `offset`, the disc lies beside the
/// path, displaced from its point `to`, and the path itself has only the plain margin.
struct Joint {
  double from = 0.0;
  double to = 0.0;
  double margin = 0.0;
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();

  [[nodiscard]] bool beside() const noexcept { return !offset.isZero(0.0); }
};

/// The part of the path that one rectangle must contain, from `begin.from` to `end.to`. The joints
/// at its ends have their own margins; `margin` applies between them. Lengths are in cells.
struct PathPiece {
  Joint begin;
  Joint end;
  double margin = 0.0;

  /// Calls visit(point, margin) for points whose convex hull, margins included, contains the piece.
  template <typename Visitor>
  void visit(const PathTrack& track, Visitor&& visit_point) const {
    const double begin_margin = begin.beside() ? margin : begin.margin;
    const double end_margin = end.beside() ? margin : end.margin;
    const std::size_t first = track.segment(begin.from);
    visit_point(track.at(begin.from, first), begin_margin);
    if (begin.to > begin.from) visit_point(track.at(begin.to), begin_margin);
    std::size_t last = first;  // the segment of end.to
    for (; last + 2 < track.points().size() && track.arc()[last + 1] < end.to; ++last) {
      const double s = track.arc()[last + 1];
      const bool joint = s <= begin.to || s >= end.from;
      const double joint_margin = s <= begin.to ? begin_margin : end_margin;
      visit_point(track.points()[last + 1], joint ? joint_margin : margin);
    }
    if (end.from < end.to) visit_point(track.at(end.from), end_margin);
    visit_point(track.at(end.to, last), end_margin);
    if (begin.beside()) visit_point(track.at(begin.to) + begin.offset, begin.margin);
    if (end.beside()) visit_point(track.at(end.to, last) + end.offset, end.margin);
  }

  /// Returns the smallest box in `frame` that contains the piece and the frame's origin.
  [[nodiscard]] Box bounds(const PathTrack& track, const TurnedFrame& frame) const noexcept {
    Box box;
    visit(track, [&](const Eigen::Vector2d& point, double margin_here) {
      const Eigen::Vector2d p = frame.turned(point - frame.origin);
      const Eigen::Vector2d by = Eigen::Vector2d::Constant(margin_here);
      box.min = box.min.cwiseMin(p - by);
      box.max = box.max.cwiseMax(p + by);
    });
    return box;
  }
};

}  // namespace fairway
