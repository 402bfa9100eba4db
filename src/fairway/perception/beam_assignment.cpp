// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/beam_assignment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fairway {

namespace {

constexpr double kGate = 0.25;  // [m]; kGateSigmas standard deviations are added
constexpr double kGateSigmas = 2.0;
constexpr double kWidestGate = 0.8;  // [m]

// How unlikely a point at some distance from the outline of a track is: twice the negative
// logarithm of a normal distribution. An uncertain track thus takes no points from a certain one.
struct Likelihood {
  Likelihood() = default;
  explicit Likelihood(const MovingTrack& track) noexcept {
    const double sigma = track.position_sigma();
    gate = std::min(kWidestGate, kGate + kGateSigmas * sigma);
    inverse_variance = 1.0 / (kPointSigma * kPointSigma + sigma * sigma);
    offset = -std::log(inverse_variance);
  }

  [[nodiscard]] double of(double distance) const noexcept {
    return distance * distance * inverse_variance + offset;
  }

  double gate = 0.0;  // [m]
  double inverse_variance = 0.0;
  double offset = 0.0;
};

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
      const double off = std::abs((beams[b].to - tracks[i].position()).norm() - tracks[i].radius);
      if (off >= likelihoods[i].gate) continue;
      const double unlikely = likelihoods[i].of(off);
      if (unlikely >= best) continue;
      best = unlikely;
      owner[b] = static_cast<int>(i);
    }
    if (owner[b] >= 0 && grid.is_static_near(grid.frame().cell_at(beams[b].to))) owner[b] = -1;
  }
}

}  // namespace fairway
