// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/beam_assignment.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace fairway {
namespace {

using Eigen::Vector2d;

Beam hit(const Vector2d& at) { return {.from = {0, 0}, .to = at, .end = BeamEnd::Hit}; }

std::vector<int> owners(const std::vector<Beam>& beams,
                        const std::vector<MovingTrack>& tracks,
                        const RollingGrid& grid = RollingGrid({}, {0, 0})) {
  std::vector<int> owner(beams.size(), 7);
  assign_beams(beams, tracks, grid, owner);
  return owner;
}

TEST(BeamAssignment, AHitBelongsToTheTrackAtWhoseOutlineItEnds) {
  const std::vector<MovingTrack> tracks = {new_track(0, 0.0, {3.0, 0.0}, 0.05, 0.5),
                                           new_track(1, 0.0, {3.0, 0.8}, 0.05, 0.5)};
  Beam open = hit({2.5, 0.0});
  open.end = BeamEnd::Open;
  const std::vector<Beam> beams = {hit({2.5, 0.0}), hit({2.5, 0.8}), hit({3.0, -0.5}),
                                   hit({3.0, 1.3}), hit({5.0, 0.0}), open};
  EXPECT_EQ(owners(beams, tracks), (std::vector<int>{0, 1, 0, 1, -1, -1}));
}

TEST(BeamAssignment, AnUncertainTrackTakesNoPointsFromACertainOne) {
  const std::vector<MovingTrack> tracks = {new_track(0, 0.0, {3.0, 0.0}, 0.3, 0.5),
                                           new_track(1, 0.0, {3.05, 0.0}, 0.02, 0.5)};
  // The point lies on the outline of the first disc, and 0.05 m in front of that of the second.
  EXPECT_EQ(owners({hit({2.5, 0.0})}, tracks), std::vector<int>{1});
  // Further away it belongs to the uncertain one.
  EXPECT_EQ(owners({hit({2.3, 0.0})}, tracks), std::vector<int>{0});
}

// The sensor sees the near side of an object only.
TEST(BeamAssignment, AHitBehindTheMiddleOfAnObjectIsNotIts) {
  const std::vector<MovingTrack> tracks = {new_track(0, 0.0, {3.0, 0.0}, 0.02, 0.5)};
  EXPECT_EQ(owners({hit({2.98, 0.5}), hit({3.2, 0.46})}, tracks), (std::vector<int>{0, -1}));
}

// The cells where an object stood are static because of it: what it covers there is still its own,
// but not a wall beside its outline.
TEST(BeamAssignment, AnObjectThatStoodKeepsItsPointsInItsPlace) {
  RollingGrid grid({}, {0, 0});
  const std::vector<Beam> beams = {hit({2.52, 0.01}), hit({2.63, 0.5})};
  for (int n = 0; n < 25; ++n)
    grid.insert(beams, {0, 0}, 0.2);
  std::vector<MovingTrack> tracks = {new_track(0, 0.0, {3.0, 0.05}, 0.02, 0.5)};
  EXPECT_EQ(owners(beams, tracks, grid), (std::vector<int>{-1, -1}));
  tracks[0].stood = true;
  tracks[0].born_at = {3.0, 0.0};
  tracks[0].born_radius = 0.5;
  EXPECT_EQ(owners(beams, tracks, grid), (std::vector<int>{0, -1}));
}

TEST(BeamAssignment, AKnownObstacleBelongsToNoTrack) {
  RollingGrid grid({}, {0, 0});
  const std::vector<MovingTrack> tracks = {new_track(0, 0.0, {3.0, 0.0}, 0.05, 0.5)};
  const std::vector<Beam> beams = {hit({2.51, 0.01})};
  EXPECT_EQ(owners(beams, tracks, grid), std::vector<int>{0});
  grid.insert(beams, {0, 0}, 0.2);
  EXPECT_EQ(owners(beams, tracks, grid), std::vector<int>{-1});
}

}  // namespace
}  // namespace fairway
