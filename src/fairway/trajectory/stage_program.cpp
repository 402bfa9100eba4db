// SPDX-License-Identifier: Apache-2.0
#include "fairway/trajectory/stage_program.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace fairway::internal {

namespace {

using StateMatrix = Eigen::Matrix<double, kStates, kStates>;
using ControlMatrix = Eigen::Matrix<double, kControls, kControls>;
using Gain = Eigen::Matrix<double, kControls, kStates>;

// The Riccati recursion's part of one stage, kept to be used with a second gradient.
struct Factor {
  Eigen::LLT<ControlMatrix> control;
  Gain gain;
  ControlVector offset;
};

class Method {
 public:
  Method(StageProgram& program, StageSolution& solution) noexcept
      : program_(program),
        solution_(solution) {}

  void run(int max_iterations) {
    prepare();
    for (int i = 0; i < max_iterations; ++i) {
      solution_.iterations = i + 1;
      const double gap = measure();
      constexpr double kGap = 1e-7;
      constexpr double kResidual = 1e-7;
      // What is left of the first gradient: every step takes its length off.
      constexpr double kUnsettled = 1e-6;
      if (gap < kGap && greatest_residual_ < kResidual && unsettled_ < kUnsettled) {
        solution_.solved = true;
        return;
      }
      if (!factorise()) return;
      // Predictor: straight to the boundary; then as much centring as it could not do without.
      step(0.0, false);
      const double reachable = gap_after(longest_primal(1.0), longest_dual(1.0));
      const double ratio = gap > 0.0 ? reachable / gap : 0.0;
      step(ratio * ratio * ratio * gap, true);
      constexpr double kToBoundary = 0.99;
      move(longest_primal(kToBoundary), longest_dual(kToBoundary));
    }
    solution_.solved = measure() < 1e-4 && greatest_residual_ < 1e-5 && unsettled_ < 1e-3;
  }

 private:
  void prepare() {
    const std::size_t count = program_.stages.size();
    solution_.variables.assign(count, StageVector::Zero());
    solution_.last_state.setZero();
    steps_.assign(count, StageVector::Zero());
    factors_.resize(count);
    // States that follow from no change of the controls; every step keeps the motion then.
    for (std::size_t k = 0; k < count; ++k) {
      const Stage& stage = program_.stages[k];
      solution_.variables[k].head<kStates>() = solution_.last_state;
      solution_.last_state = stage.transition * solution_.variables[k] + stage.offset;
    }
    for (Stage& stage : program_.stages) {
      for (StageConstraint& c : stage.constraints) {
        c.slack = std::max(c.bound, 1e-2);
        c.multiplier = 1e-2 / c.slack;
      }
    }
  }

  // Mean complementarity; and the residuals of the constraints.
  double measure() noexcept {
    double sum = 0.0;
    std::size_t count = 0;
    greatest_residual_ = 0.0;
    for (std::size_t k = 0; k < program_.stages.size(); ++k) {
      for (StageConstraint& c : program_.stages[k].constraints) {
        c.residual = c.gradient.dot(solution_.variables[k]) + c.slack - c.bound;
        greatest_residual_ = std::max(greatest_residual_, std::abs(c.residual));
        sum += c.slack * c.multiplier;
        ++count;
      }
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
  }

  bool factorise() {
    StateMatrix value = program_.last_hessian;
    for (std::size_t k = program_.stages.size(); k-- > 0;) {
      const Stage& stage = program_.stages[k];
      Factor& factor = factors_[k];
      StageMatrix m = stage.hessian;
      for (const StageConstraint& c : stage.constraints) {
        const StageVector scaled = (c.multiplier / c.slack) * c.gradient;
        m.noalias() += scaled * c.gradient.transpose();
      }
      const Eigen::Matrix<double, kStates, kVariables> moved = value * stage.transition;
      m.noalias() += stage.transition.transpose() * moved;
      factor.control.compute(m.bottomRightCorner<kControls, kControls>());
      if (factor.control.info() != Eigen::Success) return false;
      const Gain cross = m.bottomLeftCorner<kControls, kStates>();
      factor.gain = -factor.control.solve(cross);
      value = m.topLeftCorner<kStates, kStates>();
      value.noalias() += cross.transpose() * factor.gain;
      value = 0.5 * (value + value.transpose()).eval();
    }
    return true;
  }

  // Newton's step towards complementarity `target`; second-order term from the step before.
  void step(double target, bool correct) {
    StateVector slope = program_.last_hessian * solution_.last_state + program_.last_gradient;
    for (std::size_t k = program_.stages.size(); k-- > 0;) {
      Stage& stage = program_.stages[k];
      Factor& factor = factors_[k];
      StageVector g = stage.hessian * solution_.variables[k] + stage.gradient;
      for (StageConstraint& c : stage.constraints) {
        const double second = correct ? c.slack_step * c.multiplier_step : 0.0;
        const double wanted = (target - second) / c.slack;
        g.noalias() += (wanted + c.multiplier / c.slack * c.residual) * c.gradient;
      }
      g.noalias() += stage.transition.transpose() * slope;
      factor.offset = -factor.control.solve(g.tail<kControls>());
      slope = g.head<kStates>();
      slope.noalias() += factor.gain.transpose() * g.tail<kControls>();
    }
    StateVector state = StateVector::Zero();
    for (std::size_t k = 0; k < program_.stages.size(); ++k) {
      const Factor& factor = factors_[k];
      steps_[k].head<kStates>() = state;
      steps_[k].tail<kControls>() = factor.gain * state + factor.offset;
      state = program_.stages[k].transition * steps_[k];
      for (StageConstraint& c : program_.stages[k].constraints) {
        const double second = correct ? c.slack_step * c.multiplier_step : 0.0;
        const double slack_step = -c.residual - c.gradient.dot(steps_[k]);
        c.multiplier_step = (target - second - c.multiplier * slack_step) / c.slack - c.multiplier;
        c.slack_step = slack_step;
      }
    }
    last_step_ = state;
  }

  template <typename Part>
  [[nodiscard]] double longest(double share, Part&& part) const noexcept {
    double length = 1.0;
    for (const Stage& stage : program_.stages) {
      for (const StageConstraint& c : stage.constraints) {
        const auto [value, change] = part(c);
        if (change < 0.0) length = std::min(length, -share * value / change);
      }
    }
    return length;
  }
  [[nodiscard]] double longest_primal(double share) const noexcept {
    return longest(share,
                   [](const StageConstraint& c) { return std::pair(c.slack, c.slack_step); });
  }
  [[nodiscard]] double longest_dual(double share) const noexcept {
    return longest(
        share, [](const StageConstraint& c) { return std::pair(c.multiplier, c.multiplier_step); });
  }

  [[nodiscard]] double gap_after(double primal, double dual) const noexcept {
    double sum = 0.0;
    std::size_t count = 0;
    for (const Stage& stage : program_.stages) {
      for (const StageConstraint& c : stage.constraints) {
        sum += (c.slack + primal * c.slack_step) * (c.multiplier + dual * c.multiplier_step);
        ++count;
      }
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
  }

  void move(double primal, double dual) noexcept {
    // The Hessian couples both: a common length keeps the stationarity residual shrinking.
    const double length = std::min(primal, dual);
    unsettled_ *= 1.0 - length;
    for (std::size_t k = 0; k < program_.stages.size(); ++k) {
      solution_.variables[k] += length * steps_[k];
      for (StageConstraint& c : program_.stages[k].constraints) {
        c.slack += length * c.slack_step;
        c.multiplier += length * c.multiplier_step;
      }
    }
    solution_.last_state += length * last_step_;
  }

  StageProgram& program_;
  StageSolution& solution_;
  std::vector<Factor> factors_;
  std::vector<StageVector> steps_;
  StateVector last_step_ = StateVector::Zero();
  double greatest_residual_ = 0.0;
  double unsettled_ = 1.0;
};

}  // namespace

void solve(StageProgram& program, int max_iterations, StageSolution& solution) {
  solution.solved = false;
  solution.iterations = 0;
  Method(program, solution).run(max_iterations);
}

}  // namespace fairway::internal
