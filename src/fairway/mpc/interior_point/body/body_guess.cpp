// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fairway/mpc/interior_point/body/body_setup.hpp"

// Initial inputs: a guess, or a drive towards the targets, moved strictly inside every bound.

namespace fairway::interior_point {
namespace {

constexpr std::size_t kHeld = 3;          // steps for which the drive holds an input
constexpr std::size_t kSeen = 2 * kHeld;  // steps by which it judges one
constexpr double kPartOfPenalty = 0.5;    // of a violation: the drive looks for a route

// A pose relative to the start.
struct LocalPose {
  double x = 0.0, y = 0.0, heading = 0.0;
};

template <typename Motion>
LocalPose advanced(const BodyWorkspace<Motion>& w,
                   const LocalPose& pose,
                   const typename Motion::Input& input) noexcept {
  const double dt = w.problem->dt;
  const PlanarTwist twist = w.problem->motion.twist(input);
  const double phi = pose.heading + 0.5 * dt * twist.angular;
  const double c = dt * std::cos(phi);
  const double s = dt * std::sin(phi);
  return {pose.x + c * twist.linear - s * twist.lateral,
          pose.y + s * twist.linear + c * twist.lateral, pose.heading + dt * twist.angular};
}

// Sums the violations of the corridor at pose k + 1.
template <typename Motion>
double side_violation(const BodyWorkspace<Motion>& w,
                      const LocalPose& pose,
                      std::size_t k) noexcept {
  const ConstraintRange& range = w.constraint_ranges[k / kLanes];
  const std::size_t lane = k % kLanes;
  const double c = std::cos(pose.heading);
  const double s = std::sin(pose.heading);
  double sum = 0.0;
  for (std::size_t i = range.corridor; i < range.barrier; ++i) {
    const BodyConstraintBlock& side = w.soft_constraints[i];
    const Eigen::Vector2d& mark = w.marks[side.mark];
    const double x = pose.x + c * mark.x() - s * mark.y();
    const double y = pose.y + s * mark.x() + c * mark.y();
    sum += std::max(0.0, -(side.offset[lane] + side.normal_x[lane] * x + side.normal_y[lane] * y));
  }
  return sum;
}

// Cost of pose k + 1 and of the input that leads there.
template <typename Motion>
double cost_at(const BodyWorkspace<Motion>& w, const LocalPose& pose, std::size_t k) noexcept {
  const double dx = pose.x - w.target_x[k];
  const double dy = pose.y - w.target_y[k];
  const double turn = pose.heading - w.target_heading[k];
  return w.weight_x[k] * dx * dx + w.weight_y[k] * dy * dy + w.weight_heading[k] * turn * turn +
         kPartOfPenalty * w.problem->violation_weight * side_violation(w, pose, k);
}

// Merit of holding an input from step k on.
template <typename Motion>
double outlook(const BodyWorkspace<Motion>& w,
               LocalPose pose,
               const typename Motion::Input& input,
               std::size_t first,
               double best) noexcept {
  const std::size_t last = std::min(first + kSeen, w.horizon);
  double merit = static_cast<double>(last - first) * w.problem->input_weight.dot(input.cwiseAbs2());
  for (std::size_t k = first; k < last && merit < best; ++k) {
    pose = advanced(w, pose, input);
    merit += cost_at(w, pose, k);
  }
  return merit;
}

// Moves an input into the half-planes of step k, towards one that is inside of them.
template <typename Motion>
typename Motion::Input within_limits(const BodyWorkspace<Motion>& w,
                                     std::size_t k,
                                     const typename Motion::Input& inside,
                                     const typename Motion::Input& input) noexcept {
  double share = 1.0;
  for (std::size_t i = 0; i < w.num_limits; ++i) {
    const auto& normal = w.problem->input_limits[i].normal;
    const double slope = normal.dot(input - inside);
    const double distance = w.input_bounds.limits[k][i] - normal.dot(inside);
    if (slope > distance) share = std::min(share, distance / slope);
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

// Share of the range from lowest to highest value of input `j` in candidate `i`.
constexpr std::array<double, 5> kShares = {0.0, 0.25, 0.5, 0.75, 1.0};

// Returns the best of a grid of inputs, each as far as the change bound allows in half of the steps
// that it is held for.
template <typename Motion>
typename Motion::Input best_input(const BodyWorkspace<Motion>& w,
                                  const LocalPose& pose,
                                  const typename Motion::Input& before,
                                  std::size_t k) noexcept {
  constexpr double kReached = 0.5 * (kHeld + 1);
  constexpr std::size_t n = Motion::kInputs;
  constexpr std::size_t kPerInput = n == 2 ? kShares.size() : 3;
  constexpr std::size_t kStride = (kShares.size() - 1) / (kPerInput - 1);
  const typename Motion::Input low =
      w.input_bounds.low[k].cwiseMax(before - kReached * w.problem->max_change);
  const typename Motion::Input high =
      w.input_bounds.high[k].cwiseMin(before + kReached * w.problem->max_change);
  std::size_t count = 1;
  for (std::size_t j = 0; j < n; ++j)
    count *= kPerInput;
  typename Motion::Input best = w.input_bounds.inside[k];
  double least = outlook(w, pose, best, k, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < count; ++i) {
    typename Motion::Input input;
    std::size_t rest = i;
    for (std::size_t j = 0; j < n; ++j, rest /= kPerInput) {
      const auto at = static_cast<Eigen::Index>(j);
      input[at] = low[at] + kShares[kStride * (rest % kPerInput)] * (high[at] - low[at]);
    }
    input = within_limits(w, k, w.input_bounds.inside[k], input);
    const double merit = outlook(w, pose, input, k, least);
    if (!(merit < least)) continue;
    least = merit;
    best = input;
  }
  return best;
}

template <typename Motion>
void drive_towards_targets(const BodyWorkspace<Motion>& w,
                           std::array<typename Motion::Input, kMaxHorizon>& inputs) noexcept {
  LocalPose pose{.x = 0.0, .y = 0.0, .heading = w.points[0].heading[0]};
  typename Motion::Input before = w.problem->previous_input;
  typename Motion::Input held = before;
  for (std::size_t k = 0; k < w.horizon; ++k) {
    if (k % kHeld == 0) held = best_input(w, pose, before, k);
    before = inputs[k] = clipped(w, k, before, held);
    pose = advanced(w, pose, before);
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
      allow(normal.dot(move), std::numeric_limits<double>::infinity(),
            bounds.limits[k][i] - normal.dot(inside));
    }
    before = inside;
    move_before = move;
  }
  return share;
}

}  // namespace

template <typename Motion>
void load_body_guess(const BodyGuess<Motion>& guess,
                     const BodyWorkspace<Motion>& w,
                     BodyPoint<Motion>& point) noexcept {
  // Shares by which a guess, and the drive that replaces a missing guess, move inwards.
  constexpr double kInwards = 0.005;
  constexpr double kDriveInwards = 0.1;
  const auto given = static_cast<std::size_t>(std::clamp(guess.count, 0, kMaxHorizon));
  std::array<typename Motion::Input, kMaxHorizon> inputs;
  if (given == 0) drive_towards_targets(w, inputs);
  typename Motion::Input before = w.problem->previous_input;
  for (std::size_t k = 0; given > 0 && k < w.horizon; ++k) {
    typename Motion::Input input = guess.inputs[std::min(k, given - 1)];
    if (!input.allFinite()) input = w.input_bounds.inside[k];
    before = inputs[k] = clipped(w, k, before, input);
  }
  const double share = (1.0 - (given > 0 ? kInwards : kDriveInwards)) * allowed_share(w, inputs);
  for (std::size_t k = 0; k < w.horizon; ++k) {
    const typename Motion::Input& inside = w.input_bounds.inside[k];
    for (int j = 0; j < Motion::kInputs; ++j)
      point.inputs[static_cast<std::size_t>(j)][k + 1] =
          inside[j] + share * (inputs[k][j] - inside[j]);
  }
}

template void load_body_guess(const BodyGuess<UnicycleMotion>&,
                              const BodyWorkspace<UnicycleMotion>&,
                              BodyPoint<UnicycleMotion>&) noexcept;
template void load_body_guess(const BodyGuess<SteeredMotion>&,
                              const BodyWorkspace<SteeredMotion>&,
                              BodyPoint<SteeredMotion>&) noexcept;
template void load_body_guess(const BodyGuess<OmniMotion>&,
                              const BodyWorkspace<OmniMotion>&,
                              BodyPoint<OmniMotion>&) noexcept;

}  // namespace fairway::interior_point
