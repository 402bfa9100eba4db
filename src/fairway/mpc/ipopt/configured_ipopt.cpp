// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/ipopt/configured_ipopt.hpp"

#include <stdexcept>

#include <IpSolveStatistics.hpp>

namespace fairway {

ConfiguredIpopt::ConfiguredIpopt(const IpoptSettings& settings)
    : guess_barrier_(settings.guess_barrier),
      application_(new Ipopt::IpoptApplication(false)) {
  Ipopt::OptionsList& options = *application_->Options();
  options.SetIntegerValue("print_level", 0);
  options.SetStringValue("sb", "yes");  // no banner
  options.SetStringValue("linear_solver", "mumps");
  options.SetIntegerValue("max_iter", settings.max_iterations);
  options.SetNumericValue("tol", settings.tolerance);
  // Bounds hold exactly instead of within 1e-8.
  options.SetNumericValue("bound_relax_factor", 0.0);
  // The empty name prevents reading a file ipopt.opt in the working directory.
  if (application_->Initialize("") != Ipopt::Solve_Succeeded)
    throw std::runtime_error("IPOPT could not be initialised with MUMPS");
}

Ipopt::ApplicationReturnStatus ConfiguredIpopt::solve(const Ipopt::SmartPtr<Ipopt::TNLP>& nlp,
                                                      bool has_guess,
                                                      int& iterations) {
  Ipopt::OptionsList& options = *application_->Options();
  options.SetNumericValue("mu_init", has_guess ? guess_barrier_ : 0.1);
  for (const char* push : {"bound_push", "bound_frac", "slack_bound_push", "slack_bound_frac"})
    options.SetNumericValue(push, has_guess ? 1e-4 : 1e-2);
  const Ipopt::ApplicationReturnStatus status = application_->OptimizeTNLP(nlp);
  const Ipopt::SmartPtr<Ipopt::SolveStatistics> statistics = application_->Statistics();
  if (IsValid(statistics)) iterations = statistics->IterationCount();
  return status;
}

}  // namespace fairway
