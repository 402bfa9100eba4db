// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "fairway/simulation/trace.hpp"

namespace fairway {

/// The least member of a sample that at least `share` of it do not exceed.
/// @param sorted  In ascending order. @pre not empty, 0 <= share <= 1.
[[nodiscard]] double quantile(std::span<const double> sorted, double share);

/// Order statistics of a sample; zeros for an empty one.
struct Quantiles {
  double median = 0.0;
  double p99 = 0.0;  ///< the least value that at least 99 % of the sample do not exceed
  double max = 0.0;
};

[[nodiscard]] Quantiles quantiles(std::span<const double> sample);

/// Integral over time of the squared rates of change of both speeds of one robot. It is the sum of
/// ((du/dt)^2 + (dr/dt)^2) dt over its commands [m^2/s^3 + rad^2/s^3]. Less is smoother.
[[nodiscard]] double smoothness(const Trace& trace, std::size_t robot);

/// How often the current rectangle changed while one robot drove.
[[nodiscard]] int rectangle_switches(const Trace& trace, std::size_t robot);

}  // namespace fairway
