// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fairway/mpc/interior_point/body/body_kernels.hpp"
#include "fairway/mpc/interior_point/body/body_setup.hpp"

// Initial inputs: a guess, or a drive towards the targets, moved strictly inside every bound.

namespace fairway::interior_point {
namespace {

// Moves an input into the limits of step k, towards one that is inside of them.
template <typename Motion>
typename Motion::Input within_limits(const BodyWorkspace<Motion>& w,
                                     std::size_t k,
                                     const typename Motion::Input& inside,
                                     const typename Motion::Input& input) noexcept {
  double share = 1.0;
  for (std::size_t i = 0; i < w.num_limits; ++i) {
    const auto& normal = w.problem->input_limits[i].normal;
    const double slope = normal.dot(input - inside);
    const double place = slope > 0.0 ? normal.dot(inside) : -normal.dot(inside);
    const double distance = w.input_bounds.limits[k][i] - place;
    if (std::abs(slope) > distance) share = std::min(share, distance / std::abs(slope));
  }
  return inside + share * (input - inside);
}

// Clips an input to the bounds of step k and to the change from the one before.
template <typename Motion>
typename Motion::Input clipped(const BodyWorkspace<Motion>& w,
                               std::size_t k,
                               const typename Motion::Input& before,
                               const typename Motion::Input& input) noexcept {
  const typename Motion::Input low = w.input_bounds.low[k].cwiseMax(before - w.problem->max_change);
  const typename Motion::Input high =
      w.input_bounds.high[k].cwiseMin(before + w.problem->max_change);
  return within_limits(w, k, w.input_bounds.inside[k], input.cwiseMin(high).cwiseMax(low).eval());
}

// Share of the range from its lowest to its highest value, by candidate.
constexpr std::array<double, 5> kShares = {0.0, 0.25, 0.5, 0.75, 1.0};

// A grid of inputs, each as far as the change bound allows in half of the steps that it is held
// for. The remaining ones are the input inside the bounds.
template <typename Motion>
void find_candidates(const BodyWorkspace<Motion>& w,
                     const typename Motion::Input& before,
                     std::size_t k,
                     Candidates<Motion>& candidates) noexcept {
  constexpr double kReached = 0.5 * (kDriveHold + 1);
  constexpr std::size_t n = Motion::kInputs;
  constexpr std::size_t kPerInput = n == 2 ? kShares.size() : 3;
  constexpr std::size_t kStride = (kShares.size() - 1) / (kPerInput - 1);
  const typename Motion::Input& inside = w.input_bounds.inside[k];
  const typename Motion::Input low =
      w.input_bounds.low[k].cwiseMax(before - kReached * w.problem->max_change);
  const typename Motion::Input high =
      w.input_bounds.high[k].cwiseMin(before + kReached * w.problem->max_change);
  std::size_t count = 1;
  for (std::size_t j = 0; j < n; ++j)
    count *= kPerInput;
  for (std::size_t i = 0; i < candidates.inputs.size(); ++i) {
    typename Motion::Input input = inside;
    std::size_t rest = i;
    for (std::size_t j = 0; i < count && j < n; ++j, rest /= kPerInput) {
      const auto at = static_cast<Eigen::Index>(j);
      input[at] = low[at] + kShares[kStride * (rest % kPerInput)] * (high[at] - low[at]);
    }
    candidates.set(w, i, within_limits(w, k, inside, input));
  }
}

template <typename Motion>
void drive_towards_targets(const BodyKernels<Motion>& kernels,
                           const BodyWorkspace<Motion>& w,
                           std::array<typename Motion::Input, kMaxHorizon>& inputs) noexcept {
  Pose2 pose{.position = Eigen::Vector2d::Zero(), .heading = w.points[0].heading[0]};
  typename Motion::Input before = w.problem->previous_input;
  typename Motion::Input held = before;
  Candidates<Motion> candidates;
  for (std::size_t k = 0; k < w.horizon; ++k) {
    if (k % kDriveHold == 0) {
      find_candidates(w, before, k, candidates);
      held = candidates.inputs[kernels.best_candidate(w, pose, k, candidates)];
    }
    before = inputs[k] = clipped(w, k, before, held);
    pose = midpoint_step(pose, w.problem->motion.twist(before), w.problem->dt);
  }
}

// Returns the greatest share by which all inputs may move from the inner sequence towards `inputs`.
template <typename Motion>
double allowed_share(const BodyWorkspace<Motion>& w,
                     const std::array<typename Motion::Input, kMaxHorizon>& inputs) noexcept {
  const InputBounds<Motion>& bounds = w.input_bounds;
  double share = 1.0;
  const auto allow = [&share](double move, double below, double above) {
    if (move > above) share = std::min(share, above / move);
    if (-move > below) share = std::min(share, below / -move);
  };
  typename Motion::Input before = w.problem->previous_input;
  typename Motion::Input move_before = Motion::Input::Zero();
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const typename Motion::Input& inside = bounds.inside[k];
    const typename Motion::Input move = inputs[k] - inside;
    for (int j = 0; j < Motion::kInputs; ++j) {
      allow(move[j], inside[j] - bounds.low[k][j], bounds.high[k][j] - inside[j]);
      const double change = inside[j] - before[j];
      const double most = w.problem->max_change[j];
      allow(move[j] - move_before[j], most + change, most - change);
    }
    for (std::size_t i = 0; i < w.num_limits; ++i) {
      const auto& normal = w.problem->input_limits[i].normal;
      const double place = normal.dot(inside);
      allow(normal.dot(move), bounds.limits[k][i] + place, bounds.limits[k][i] - place);
    }
    before = inside;
    move_before = move;
  }
  return share;
}

}  // namespace

template <typename Motion>
void load_body_guess(const BodyKernels<Motion>& kernels,
                     const BodyGuess<Motion>& guess,
                     const BodyWorkspace<Motion>& w,
                     BodyPoint<Motion>& point) noexcept {
  // Shares by which a guess, and the drive that replaces a missing guess, move inwards.
  constexpr double kInwards = 0.005;
  constexpr double kDriveInwards = 0.1;
  const auto given = static_cast<std::size_t>(std::clamp(guess.count, 0, kMaxHorizon));
  std::array<typename Motion::Input, kMaxHorizon> inputs;
  if (given == 0) drive_towards_targets(kernels, w, inputs);
  typename Motion::Input before = w.problem->previous_input;
  for (std::size_t k = 0; given > 0 && k < w.horizon; ++k) {
    typename Motion::Input input = guess.inputs[std::min(k, given - 1)];
    if (!input.allFinite()) input = w.input_bounds.inside[k];
    before = inputs[k] = clipped(w, k, before, input);
  }
  const double share = (1.0 - (given > 0 ? kInwards : kDriveInwards)) * allowed_share(w, inputs);
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const typename Motion::Input& inside = w.input_bounds.inside[k];
    for (int j = 0; j < Motion::kInputs; ++j) {
      point.inputs[static_cast<std::size_t>(j)][k + 1] =
          inside[j] + share * (inputs[k][j] - inside[j]);
    }
  }
}

template void load_body_guess(const BodyKernels<UnicycleMotion>&,
                              const BodyGuess<UnicycleMotion>&,
                              const BodyWorkspace<UnicycleMotion>&,
                              BodyPoint<UnicycleMotion>&) noexcept;
template void load_body_guess(const BodyKernels<SteeredMotion>&,
                              const BodyGuess<SteeredMotion>&,
                              const BodyWorkspace<SteeredMotion>&,
                              BodyPoint<SteeredMotion>&) noexcept;
template void load_body_guess(const BodyKernels<OmniMotion>&,
                              const BodyGuess<OmniMotion>&,
                              const BodyWorkspace<OmniMotion>&,
                              BodyPoint<OmniMotion>&) noexcept;

}  // namespace fairway::interior_point
