#pragma once
#include "fairway/mpc/control_solver.hpp"
#include "fairway/mpc/mpc_settings.hpp"
namespace fairway {
class RealTimeSolver final : public ControlSolver {
 public:
  explicit RealTimeSolver(const MpcSettings&) {}
  const MpcSolution& solve(const ControlProblem&, const InitialGuess&) noexcept override { return s_; }
 private: MpcSolution s_;
};
}
