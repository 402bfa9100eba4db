// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/sensors/noise.hpp"

#include <cmath>

namespace fairway {

// Marsaglia's polar method needs neither sine nor cosine, whose last bits differ between libraries.
double Noise::normal(double sigma) {
  double u = 0.0;
  double square = 0.0;
  do {
    u = uniform(-1.0, 1.0);
    const double v = uniform(-1.0, 1.0);
    square = u * u + v * v;
  } while (square >= 1.0 || square == 0.0);
  return sigma * u * std::sqrt(-2.0 * std::log(square) / square);
}

}  // namespace fairway
