// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <IpIpoptApplication.hpp>

#include "fairway/mpc/ipopt/ipopt_solver.hpp"

namespace fairway {

/// IPOPT with the options of the reference solvers.
class ConfiguredIpopt {
 public:
  /// @throws std::runtime_error if IPOPT cannot be initialised.
  explicit ConfiguredIpopt(const IpoptSettings& settings);

  /// Solves a problem.
  /// @param has_guess   Whether its start is near a solution: it is hardly moved from its bounds
  /// then,
  ///                    and the barrier begins at `IpoptSettings::guess_barrier`.
  /// @param iterations  Set to their number, if IPOPT knows it.
  Ipopt::ApplicationReturnStatus solve(const Ipopt::SmartPtr<Ipopt::TNLP>& nlp,
                                       bool has_guess,
                                       int& iterations);

 private:
  double guess_barrier_;
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application_;
};

}  // namespace fairway
