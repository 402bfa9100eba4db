// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/beam_assignment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fairway {

namespace {

using Eigen::Vector2d;

constexpr double kGate = 0.25;     // [m]; kGateSigmas standard deviations are added
constexpr double kPostGate = 0.1;  // [m], of what may be a post: no points of others beside it
constexpr double kGateSigmas = 2.0;
constexpr double kWidestGate = 0.8;  // [m]

// How unlikely a point at some distance from the outline of a track is: twice the negative
// logarithm of a normal distribution. An uncertain track thus takes no points from a certain one.
struct Likelihood {
  Likelihood() = default;
  explicit Likelihood(const MovingTrack& track) noexcept {
    const double sigma = track.position_sigma();
    const double least = track.may_be_post ? kPostGate : kGate;
    const double gate = std::min(kWidestGate, least + kGateSigmas * sigma);
    inverse_variance = 1.0 / (kPointSigma * kPointSigma + sigma * sigma);
    offset = -std::log(inverse_variance);
    center = track.position();
    const double inner = track.radius - gate;
    inner_square = inner > 0.0 ? inner * inner : -1.0;
    outer_square = (track.radius + gate) * (track.radius + gate);
  }

  [[nodiscard]] double of(double distance) const noexcept {
    return distance * distance * inverse_variance + offset;
  }

  Vector2d center = Vector2d::Zero();
  double inner_square = 0.0;  // of the ring around the outline in which points are taken [m^2]
  double outer_square = 0.0;
  double inverse_variance = 0.0;
  double offset = 0.0;
};

// Whether a beam ends behind the side of an object that the sensor sees: at a wall beside it.
bool is_behind(const MovingTrack& track, const Beam& beam) noexcept {
  constexpr double kOff = 0.05;  // [m]
  const Vector2d away = track.position() - beam.from;
  return (beam.to - track.position()).dot(away) >
         (kOff + kGateSigmas * track.position_sigma()) * away.norm();
}

// Whether a point lies on the outline of a track, in the place where the object stood: the cells
// there are static because of it.
bool is_in_place_of(const MovingTrack& track, const Vector2d& point) noexcept {
  constexpr double kBeside = 0.1;    // [m]; evidence of a hit counts in the cells beside it
  constexpr double kOutline = 0.06;  // [m]; what is further away may be a wall behind it
  const double off = (point - track.position()).norm() - track.radius;
  return track.stood && std::abs(off) < kOutline &&
         (point - track.born_at).norm() < track.born_radius + kBeside;
}

}  // namespace

void assign_beams(std::span<const Beam> beams,
                  std::span<const MovingTrack> tracks,
                  const RollingGrid& grid,
                  std::span<int> owner) noexcept {
  std::fill(owner.begin(), owner.end(), -1);
  std::array<Likelihood, kMaxTracks> likelihoods;
  const std::size_t count = std::min(tracks.size(), kMaxTracks);
  for (std::size_t i = 0; i < count; ++i)
    likelihoods[i] = Likelihood(tracks[i]);
  for (std::size_t b = 0; b < beams.size(); ++b) {
    if (beams[b].end != BeamEnd::Hit) continue;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
      const double square = (beams[b].to - likelihoods[i].center).squaredNorm();
      if (square >= likelihoods[i].outer_square || square <= likelihoods[i].inner_square) continue;
      const double off = std::abs(std::sqrt(square) - tracks[i].radius);
      const double unlikely = likelihoods[i].of(off);
      if (unlikely >= best) continue;
      best = unlikely;
      owner[b] = static_cast<int>(i);
    }
    if (owner[b] < 0) continue;
    // What may be a post takes points of obstacles that are not proven to be static yet.
    const CellIndex cell = grid.frame().cell_at(beams[b].to);
    const MovingTrack& track = tracks[static_cast<std::size_t>(owner[b])];
    if (is_behind(track, beams[b])) {
      owner[b] = -1;
      continue;
    }
    if (is_in_place_of(track, beams[b].to)) continue;
    if (track.may_be_post || track.stood ? grid.is_proven_static(cell) : grid.is_static_near(cell))
      owner[b] = -1;
  }
}

}  // namespace fairway
