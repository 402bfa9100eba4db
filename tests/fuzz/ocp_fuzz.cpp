// SPDX-License-Identifier: Apache-2.0
// Reads any text as instances of the optimal control problem, and as results. Valid instances can
// be solved, and printed results read back.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>

#include "experiments/solver/ocp_instances.hpp"
#include "fairway/mpc/interior_point/solver.hpp"
#include "support/random/extreme_control_problem.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto solver = std::make_unique<fairway::InteriorPointSolver>();
  const std::string text(data, data + size);
  if (const auto instances = fairway::io::parse_ocp_instances(text, "i.txt")) {
    for (const auto& instance : *instances) {
      const auto& solution = solver->solve(fairway::io::control_problem(instance), {});
      if (!fairway::test::is_finite_solution(solution)) std::abort();
    }
  } else if (instances.error().message.find('\n') != std::string::npos) {
    std::abort();
  }
  const auto results = fairway::io::parse_ocp_results(text, "r.txt");
  if (!results) return 0;
  const std::string printed = fairway::io::format_ocp_results(*results);
  const auto again = fairway::io::parse_ocp_results(printed, "r.txt");
  if (!again || fairway::io::format_ocp_results(*again) != printed) std::abort();
  return 0;
}
