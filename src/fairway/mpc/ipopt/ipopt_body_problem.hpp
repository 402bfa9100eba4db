// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <IpTNLP.hpp>

#include "fairway/mpc/body/body_evaluation.hpp"
#include "fairway/mpc/body/input_bounds.hpp"
#include "fairway/mpc/ipopt/ipopt_solver.hpp"
#include "fairway/mpc/step_index.hpp"

namespace fairway {

/// A BodyProblem in the form that IPOPT requires (private to IpoptBodySolver and its tests).
///
/// The variables are input 0, pose 1, input 1, ..., pose N, and one slack per soft constraint
/// unless constraints are hard. The constraints are the steps of the model, the changes between
/// inputs, limits of sums of the inputs, and the soft constraints.
template <typename Motion>
class IpoptBodyProblem final : public Ipopt::TNLP {
 public:
  using Index = Ipopt::Index;
  using Number = Ipopt::Number;
  using Input = typename Motion::Input;
  static constexpr Index kInputs = Motion::kInputs;
  static constexpr Number kUnbounded = 2e19;

  explicit IpoptBodyProblem(IpoptConstraints mode) : soft_(mode == IpoptConstraints::Soft) {}

  /// Sets the problem, which must outlive the solve, and the initial inputs.
  void set(const BodyProblem<Motion>& problem, const std::array<Input, kMaxHorizon>& start) {
    problem_ = &problem;
    inputs_ = start;
    find_input_bounds(problem, bounds_);
    rollout<Motion>(problem, inputs_, poses_);
    names_.clear();
    visit_soft_constraints(problem, [&](const BodyConstraintName& n) { names_.push_back(n); });
  }
  [[nodiscard]] const std::array<Input, kMaxHorizon>& inputs() const { return inputs_; }
  [[nodiscard]] const InputBounds<Motion>& bounds() const { return bounds_; }

  bool get_nlp_info(
      Index& n, Index& m, Index& nnz_jac_g, Index& nnz_h_lag, IndexStyleEnum& style) override {
    n = slack(0) + num_slacks();
    m = soft_row(names_.size());
    nnz_jac_g = 0;
    visit_jacobian([&](Index, Index, Number) { ++nnz_jac_g; });
    const std::vector<Number> zeros(step_index(m), 0.0);
    nnz_h_lag = 0;
    visit_hessian(0.0, zeros.data(), [&](Index, Index, Number) { ++nnz_h_lag; });
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(
      Index n, Number* x_l, Number* x_u, Index m, Number* g_l, Number* g_u) override {
    std::fill(x_l, x_l + n, -kUnbounded);
    std::fill(x_u, x_u + n, kUnbounded);
    std::fill(g_l, g_l + m, 0.0);
    std::fill(g_u, g_u + m, 0.0);
    for (int k = 0; k < horizon(); ++k) {
      for (int j = 0; j < kInputs; ++j) {
        const Index i = input(k) + j;
        const double before = problem_->previous_input[j];
        const double change = problem_->max_change[j];
        x_l[i] = bounds_.low[step_index(k)][j];
        x_u[i] = bounds_.high[step_index(k)][j];
        if (k == 0) {
          x_l[i] = std::max(x_l[i], before - change);
          x_u[i] = std::min(x_u[i], before + change);
        } else {
          g_u[change_row(k) + j] = std::min(change, kUnbounded);
          g_l[change_row(k) + j] = -g_u[change_row(k) + j];
        }
      }
      for (int i = 0; i < problem_->num_input_limits; ++i) {
        g_u[limit_row(k) + i] = bounds_.limits[step_index(k)][step_index(i)];
        g_l[limit_row(k) + i] = -g_u[limit_row(k) + i];
      }
    }
    std::fill(x_l + slack(0), x_l + n, 0.0);
    std::fill(g_u + soft_row(0), g_u + m, kUnbounded);
    return true;
  }

  bool get_starting_point(
      Index n, bool, Number* x, bool, Number*, Number*, Index, bool, Number*) override {
    for (int k = 0; k < horizon(); ++k) {
      Eigen::Map<Input>(x + input(k)) = inputs_[step_index(k)];
      const Pose2& next = poses_[step_index(k + 1)];
      Eigen::Map<Eigen::Vector3d>(x + pose(k + 1)) << next.position, next.heading;
    }
    for (Index i = slack(0); i < n; ++i)
      x[i] = std::max(0.0, -constraint(step_index(i - slack(0))).margin);
    return true;
  }

  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    read(x);
    value = cost<Motion>(*problem_, inputs_, poses_);
    for (Index i = slack(0); i < n; ++i)
      value += problem_->violation_weight * x[i];
    return true;
  }

  bool eval_grad_f(Index n, const Number* x, bool, Number* grad_f) override {
    read(x);
    for (int k = 0; k < horizon(); ++k) {
      Eigen::Map<Input>(grad_f + input(k)) = cost_gradient_by_input<Motion>(*problem_, inputs_, k);
      const StepTarget& target = problem_->targets[step_index(k + 1)];
      const Pose2& at = poses_[step_index(k + 1)];
      Eigen::Vector3d error;
      error << at.position - target.position, at.heading - target.heading;
      Eigen::Map<Eigen::Vector3d>(grad_f + pose(k + 1)) = 2.0 * target.weight.cwiseProduct(error);
    }
    std::fill(grad_f + slack(0), grad_f + n, problem_->violation_weight);
    return true;
  }

  bool eval_g(Index, const Number* x, bool, Index, Number* g) override {
    read(x);
    for (int k = 0; k < horizon(); ++k) {
      const Input& now = inputs_[step_index(k)];
      const Pose2 next =
          midpoint_step(poses_[step_index(k)], problem_->motion.twist(now), problem_->dt);
      const Pose2& at = poses_[step_index(k + 1)];
      Eigen::Map<Eigen::Vector3d>(g + 3 * k) << at.position - next.position,
          at.heading - next.heading;
      if (k > 0) Eigen::Map<Input>(g + change_row(k)) = now - inputs_[step_index(k - 1)];
      for (int i = 0; i < problem_->num_input_limits; ++i)
        g[limit_row(k) + i] = problem_->input_limits[step_index(i)].normal.dot(now);
    }
    for (std::size_t i = 0; i < names_.size(); ++i)
      g[soft_row(i)] = constraint(i).margin + (soft_ ? x[slack(i)] : 0.0);
    return true;
  }

  bool eval_jac_g(Index,
                  const Number* x,
                  bool,
                  Index,
                  Index,
                  Index* rows,
                  Index* columns,
                  Number* values) override {
    if (values != nullptr) read(x);
    visit_jacobian([&](Index row, Index column, Number value) {
      if (values != nullptr) {
        *values++ = value;
      } else {
        *rows++ = row;
        *columns++ = column;
      }
    });
    return true;
  }

  bool eval_h(Index,
              const Number* x,
              bool,
              Number factor,
              Index m,
              const Number* lambda,
              bool,
              Index,
              Index* rows,
              Index* columns,
              Number* values) override {
    const std::vector<Number> zeros(step_index(m), 0.0);
    if (values != nullptr) read(x);
    visit_hessian(factor, values != nullptr ? lambda : zeros.data(),
                  [&](Index row, Index column, Number value) {
                    if (values != nullptr) {
                      *values++ = value;
                    } else {
                      *rows++ = std::max(row, column);
                      *columns++ = std::min(row, column);
                    }
                  });
    return true;
  }

  void finalize_solution(Ipopt::SolverReturn,
                         Index,
                         const Number* x,
                         const Number*,
                         const Number*,
                         Index,
                         const Number*,
                         const Number*,
                         Number,
                         const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    read(x);
  }

 private:
  // Indices in IPOPT's vectors.
  static Index input(int k) { return (kInputs + 3) * k; }
  static Index pose(int k) { return (kInputs + 3) * k - 3; }  // k >= 1
  [[nodiscard]] int horizon() const { return problem_->horizon; }
  [[nodiscard]] Index num_slacks() const { return soft_ ? static_cast<Index>(names_.size()) : 0; }
  [[nodiscard]] Index slack(std::size_t i) const {
    return (kInputs + 3) * horizon() + static_cast<Index>(i);
  }
  [[nodiscard]] Index change_row(int k) const { return 3 * horizon() + kInputs * (k - 1); }
  [[nodiscard]] Index limit_row(int k) const {
    return 3 * horizon() + kInputs * (horizon() - 1) + problem_->num_input_limits * k;
  }
  [[nodiscard]] Index soft_row(std::size_t i) const {
    return limit_row(horizon()) + static_cast<Index>(i);
  }
  [[nodiscard]] BodyConstraint constraint(std::size_t i) const {
    return soft_constraint<Motion>(*problem_, poses_, names_[i]);
  }

  void read(const Number* x) {
    for (int k = 0; k < horizon(); ++k) {
      inputs_[step_index(k)] = Eigen::Map<const Input>(x + input(k));
      const Number* at = x + pose(k + 1);
      poses_[step_index(k + 1)] = {.position = {at[0], at[1]}, .heading = at[2]};
    }
  }

  // Call sink(row, column, value) for every structural nonzero at the point read last; the Hessian
  // is a triangle of factor * cost + lambda . constraints, and IPOPT sums equal entries.
  template <typename Sink>
  void visit_jacobian(Sink&& sink) const;
  template <typename Sink>
  void visit_hessian(Number factor, const Number* lambda, Sink&& sink) const;
  template <typename Sink>
  void visit_constraint_hessian(const Number* lambda, Sink&& sink) const;

  bool soft_;
  const BodyProblem<Motion>* problem_ = nullptr;
  InputBounds<Motion> bounds_;
  std::vector<BodyConstraintName> names_;
  std::array<Input, kMaxHorizon> inputs_;  // at the point read last
  std::array<Pose2, kMaxHorizon + 1> poses_{};
};

}  // namespace fairway
