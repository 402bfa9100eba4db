// SPDX-License-Identifier: Apache-2.0
// Any numbers whatever must give a finite answer within the change bounds, or be refused.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "fairway/mpc/interior_point_solver.hpp"
#include "support/extreme_control_problem.hpp"

namespace {

class ByteSource {
 public:
  ByteSource(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  double number() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i)
      bits = bits << 8U | byte();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  double usual(double low, double high) {
    const unsigned share = byte() << 8U | byte();
    return low + (high - low) * share / 65535.0;
  }
  int integer(int low, int high) { return low + static_cast<int>(byte()) % (high - low + 1); }
  bool chance(double probability) { return byte() < 255.0 * probability; }

 private:
  // Beyond the end a fixed sequence that is not constant.
  unsigned byte() {
    const std::size_t at = position_++;
    return at < size_ ? data_[at] : static_cast<unsigned>(at * 2654435761U >> 7U & 0xffU);
  }

  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t position_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto solver = std::make_unique<fairway::InteriorPointSolver>();
  ByteSource source(data, size);
  const fairway::ControlProblem problem = fairway::test::extreme_control_problem(source);
  const fairway::InitialGuess guess = fairway::test::extreme_guess(source);
  const fairway::MpcSolution& solution = solver->solve(problem, guess, {.max_iterations = 50});
  if (!fairway::test::is_finite_solution(solution)) std::abort();
  if (solution.status != fairway::SolveStatus::InvalidProblem &&
      !fairway::test::keeps_change_bounds(problem, solution))
    std::abort();
  return 0;
}
