// SPDX-License-Identifier: Apache-2.0
// GCC warns that the calling convention for lanes of 256 bits changes with AVX. They are inlined
// and never passed.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
#include "fairway/mpc/interior_point/body/body_kernels.hpp"

#include "fairway/mpc/interior_point/body/body_guess.hpp"
#include "fairway/mpc/interior_point/body/body_iteration.hpp"
#pragma GCC diagnostic pop

namespace fairway::interior_point {
namespace {

#define FAIRWAY_BODY_KERNELS(width, Lanes, TARGET)                                                \
  template <typename Motion>                                                                      \
  TARGET std::size_t body_candidate_##width(const BodyWorkspace<Motion>& w, const Pose2& pose,    \
                                            std::size_t first,                                    \
                                            const Candidates<Motion>& candidates) noexcept {      \
    return best_candidate<Lanes>(w, pose, first, candidates);                                     \
  }                                                                                               \
  template <typename Motion>                                                                      \
  TARGET void body_evaluate_##width(const BodyWorkspace<Motion>& w,                               \
                                    BodyPoint<Motion>& point) noexcept {                          \
    evaluate<Lanes>(w, point);                                                                    \
  }                                                                                               \
  template <typename Motion>                                                                      \
  TARGET void body_start_##width(BodyWorkspace<Motion>& w, double mu) noexcept {                  \
    start<Lanes>(w, mu);                                                                          \
  }                                                                                               \
  template <typename Motion>                                                                      \
  TARGET OptimalityError body_linearise_##width(BodyWorkspace<Motion>& w, double mu) noexcept {   \
    return linearise<Lanes>(w, mu);                                                               \
  }                                                                                               \
  template <typename Motion>                                                                      \
  TARGET bool body_newton_##width(BodyWorkspace<Motion>& w, double mu) noexcept {                 \
    return solve_newton_system<Lanes>(w, mu);                                                     \
  }                                                                                               \
  template <typename Motion>                                                                      \
  TARGET bool body_step_##width(BodyWorkspace<Motion>& w, double mu, double fraction_to_boundary, \
                                Filter& filter) noexcept {                                        \
    return take_step<Lanes>(w, mu, fraction_to_boundary, filter);                                 \
  }

FAIRWAY_BODY_KERNELS(128, Lanes128, )
#ifdef FAIRWAY_HAS_LANES256
FAIRWAY_BODY_KERNELS(256, Lanes256, [[gnu::target("avx2")]])
#endif
#undef FAIRWAY_BODY_KERNELS

}  // namespace

template <typename Motion>
const BodyKernels<Motion>& body_kernels_128() noexcept {
  static constexpr BodyKernels<Motion> kKernels = {.best_candidate = body_candidate_128<Motion>,
                                                   .evaluate = body_evaluate_128<Motion>,
                                                   .start = body_start_128<Motion>,
                                                   .linearise = body_linearise_128<Motion>,
                                                   .solve_newton_system = body_newton_128<Motion>,
                                                   .take_step = body_step_128<Motion>};
  return kKernels;
}

template <typename Motion>
const BodyKernels<Motion>* body_kernels_256() noexcept {
#ifdef FAIRWAY_HAS_LANES256
  static constexpr BodyKernels<Motion> kKernels = {.best_candidate = body_candidate_256<Motion>,
                                                   .evaluate = body_evaluate_256<Motion>,
                                                   .start = body_start_256<Motion>,
                                                   .linearise = body_linearise_256<Motion>,
                                                   .solve_newton_system = body_newton_256<Motion>,
                                                   .take_step = body_step_256<Motion>};
  if (__builtin_cpu_supports("avx2") != 0) return &kKernels;
#endif
  return nullptr;
}

template const BodyKernels<UnicycleMotion>& body_kernels_128() noexcept;
template const BodyKernels<SteeredMotion>& body_kernels_128() noexcept;
template const BodyKernels<OmniMotion>& body_kernels_128() noexcept;
template const BodyKernels<UnicycleMotion>* body_kernels_256() noexcept;
template const BodyKernels<SteeredMotion>* body_kernels_256() noexcept;
template const BodyKernels<OmniMotion>* body_kernels_256() noexcept;

}  // namespace fairway::interior_point
