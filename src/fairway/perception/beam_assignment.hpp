// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "fairway/perception/object/moving_track.hpp"
#include "fairway/perception/rolling_grid.hpp"

namespace fairway {

inline constexpr std::size_t kMaxTracks = 48;  ///< further objects are not tracked
/// Standard deviation of a point of an object's surface from the disc that represents it [m].
inline constexpr double kPointSigma = 0.03;

/// Assigns hits to the tracks near whose outlines they end.
///
/// A hit goes to the track that most likely explains it: the nearer outline, or that of the more
/// certain track. Two objects that pass through each other thus keep their own points. A hit at a
/// known static obstacle goes to no track, so that a wall beside the path of an object stays a
/// wall; only in the place where an object stood, its own outline is no wall. Hits behind the
/// middle of an object go to no track.
/// @param tracks  At most kMaxTracks, predicted to the time of the scan.
/// @param owner   Filled with the index of the track of each beam; -1 for none. @pre as many as
///        beams.
void assign_beams(std::span<const Beam> beams,
                  std::span<const MovingTrack> tracks,
                  const RollingGrid& grid,
                  std::span<int> owner) noexcept;

}  // namespace fairway
