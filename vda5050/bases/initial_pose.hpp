// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway::vda5050 {

/// Fills the covariance of an initial pose as rviz does: 0.5 m and 15 degrees.
template <typename Covariance>
void set_initial_covariance(Covariance& covariance) noexcept {
  constexpr double kPosition = 0.25;   // variance of x and y [m^2]
  constexpr double kHeading = 0.0685;  // [rad^2]
  covariance[0] = covariance[7] = kPosition;
  covariance[35] = kHeading;
}

}  // namespace fairway::vda5050
