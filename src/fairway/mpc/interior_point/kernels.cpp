// SPDX-License-Identifier: Apache-2.0
// GCC warns that the calling convention for lanes of 256 bits changes with AVX. They are inlined
// and never passed.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
#include "fairway/mpc/interior_point/kernels.hpp"

#include "fairway/mpc/interior_point/line_search.hpp"
#include "fairway/mpc/interior_point/lockstep/iteration.hpp"
#include "fairway/mpc/interior_point/newton/newton.hpp"
#include "fairway/mpc/interior_point/rollout_guess.hpp"
#pragma GCC diagnostic pop

namespace fairway::interior_point {
namespace {

Drive drive_to_targets_128(const Workspace& w, DriveStart wanted, Point& point) noexcept {
  return drive_to_targets<Lanes128>(w, wanted, point);
}
void evaluate_128(const Workspace& w, Point& point) noexcept { evaluate<Lanes128>(w, point); }
void start_128(Workspace& w, double mu) noexcept { start<Lanes128>(w, mu); }
OptimalityError linearise_128(Workspace& w, double mu) noexcept {
  return linearise<Lanes128>(w, mu);
}
bool solve_newton_system_128(Workspace& w, double mu) noexcept {
  return solve_newton_system<Lanes128>(w, mu);
}
bool take_step_128(Workspace& w, double mu, double fraction_to_boundary, Filter& filter) noexcept {
  return take_step<Lanes128>(w, mu, fraction_to_boundary, filter);
}
void iterate_lockstep_128(lockstep::Lockstep& s, const lockstep::FourSettings& settings) noexcept {
  lockstep::iterate<Lanes128>(s, settings);
}

#ifdef FAIRWAY_HAS_LANES256
#define FAIRWAY_AVX2 [[gnu::target("avx2")]]
FAIRWAY_AVX2 Drive drive_to_targets_256(const Workspace& w,
                                        DriveStart wanted,
                                        Point& point) noexcept {
  return drive_to_targets<Lanes256>(w, wanted, point);
}
FAIRWAY_AVX2 void evaluate_256(const Workspace& w, Point& point) noexcept {
  evaluate<Lanes256>(w, point);
}
FAIRWAY_AVX2 void start_256(Workspace& w, double mu) noexcept { start<Lanes256>(w, mu); }
FAIRWAY_AVX2 OptimalityError linearise_256(Workspace& w, double mu) noexcept {
  return linearise<Lanes256>(w, mu);
}
FAIRWAY_AVX2 bool solve_newton_system_256(Workspace& w, double mu) noexcept {
  return solve_newton_system<Lanes256>(w, mu);
}
FAIRWAY_AVX2 bool take_step_256(Workspace& w,
                                double mu,
                                double fraction_to_boundary,
                                Filter& filter) noexcept {
  return take_step<Lanes256>(w, mu, fraction_to_boundary, filter);
}
FAIRWAY_AVX2 void iterate_lockstep_256(lockstep::Lockstep& s,
                                       const lockstep::FourSettings& settings) noexcept {
  lockstep::iterate<Lanes256>(s, settings);
}
#endif

}  // namespace

const SimdKernels& kernels_128() noexcept {
  static constexpr SimdKernels kKernels = {.drive_to_targets = drive_to_targets_128,
                                           .evaluate = evaluate_128,
                                           .start = start_128,
                                           .linearise = linearise_128,
                                           .solve_newton_system = solve_newton_system_128,
                                           .take_step = take_step_128,
                                           .iterate_lockstep = iterate_lockstep_128};
  return kKernels;
}

const SimdKernels* kernels_256() noexcept {
#ifdef FAIRWAY_HAS_LANES256
  static constexpr SimdKernels kKernels = {.drive_to_targets = drive_to_targets_256,
                                           .evaluate = evaluate_256,
                                           .start = start_256,
                                           .linearise = linearise_256,
                                           .solve_newton_system = solve_newton_system_256,
                                           .take_step = take_step_256,
                                           .iterate_lockstep = iterate_lockstep_256};
  if (__builtin_cpu_supports("avx2") != 0) return &kKernels;
#endif
  return nullptr;
}

}  // namespace fairway::interior_point
