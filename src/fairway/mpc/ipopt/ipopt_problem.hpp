// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <IpTNLP.hpp>

#include "fairway/mpc/control_problem.hpp"
#include "fairway/mpc/ipopt/ipopt_solver.hpp"
#include "fairway/mpc/solution.hpp"

namespace fairway {

/// A ControlProblem in the form that IPOPT requires (private to IpoptSolver and its tests).
///
/// The variables are command 0, pose 1, command 1, ..., pose N, and one slack per soft constraint.
/// IpoptConstraints::Hard has no slacks. The constraints are the N steps of the model (3 equations
/// each), the finite change bounds between commands, and the soft constraints (margin + slack >=
/// 0). The command range and the first change are bounds on variables.
class IpoptProblem final : public Ipopt::TNLP {
 public:
  explicit IpoptProblem(IpoptConstraints mode) : mode_(mode) {}

  /// Sets the problem and the initial commands. Both must outlive the solve.
  void set(const ControlProblem& problem, const std::array<Twist2, kMaxHorizon>& start);

  /// The result of IPOPT: commands, and the constraint with the greatest multiplier.
  [[nodiscard]] const std::array<Twist2, kMaxHorizon>& commands() const { return commands_; }
  [[nodiscard]] const ConstraintName& limiting() const { return limiting_; }

  // Callbacks of IPOPT; see its documentation of TNLP.
  using Index = Ipopt::Index;
  using Number = Ipopt::Number;
  bool get_nlp_info(
      Index& n, Index& m, Index& nnz_jac_g, Index& nnz_h_lag, IndexStyleEnum& index_style) override;
  bool get_bounds_info(
      Index n, Number* x_l, Number* x_u, Index m, Number* g_l, Number* g_u) override;
  bool get_starting_point(Index n,
                          bool init_x,
                          Number* x,
                          bool init_z,
                          Number* z_L,
                          Number* z_U,
                          Index m,
                          bool init_lambda,
                          Number* lambda) override;
  bool eval_f(Index n, const Number* x, bool new_x, Number& obj_value) override;
  bool eval_grad_f(Index n, const Number* x, bool new_x, Number* grad_f) override;
  bool eval_g(Index n, const Number* x, bool new_x, Index m, Number* g) override;
  bool eval_jac_g(Index n,
                  const Number* x,
                  bool new_x,
                  Index m,
                  Index nele_jac,
                  Index* iRow,
                  Index* jCol,
                  Number* values) override;
  bool eval_h(Index n,
              const Number* x,
              bool new_x,
              Number obj_factor,
              Index m,
              const Number* lambda,
              bool new_lambda,
              Index nele_hess,
              Index* iRow,
              Index* jCol,
              Number* values) override;
  void finalize_solution(Ipopt::SolverReturn status,
                         Index n,
                         const Number* x,
                         const Number* z_L,
                         const Number* z_U,
                         Index m,
                         const Number* g,
                         const Number* lambda,
                         Number obj_value,
                         const Ipopt::IpoptData* ip_data,
                         Ipopt::IpoptCalculatedQuantities* ip_cq) override;

 private:
  // Indices in IPOPT's vectors.
  [[nodiscard]] static Index command_index(int k) { return 5 * k; }
  [[nodiscard]] static Index pose_index(int k) { return 5 * k - 3; }  // k >= 1
  [[nodiscard]] Index slack_index(std::size_t constraint) const;
  [[nodiscard]] Index num_slacks() const;
  [[nodiscard]] Index soft_constraint_index(std::size_t constraint) const;
  [[nodiscard]] Index num_constraints() const;
  [[nodiscard]] Index num_jacobian_entries() const;
  [[nodiscard]] Index num_hessian_entries() const;

  void read(const Number* x);

  // Calls sink(row, column, value) for every structural nonzero at the point read last.
  template <typename Sink>
  void visit_jacobian(Sink&& sink) const;
  template <typename Sink>
  void visit_hessian(Number obj_factor, const Number* lambda, Sink&& sink) const;
  template <typename Sink>
  void visit_step_hessian(int k, const Number* lambda, Sink&& sink) const;

  struct ChangeBound {
    int step = 1;  // between commands step - 1 and step
    int axis = 0;  // 0 linear, 1 angular
  };

  IpoptConstraints mode_;
  const ControlProblem* problem_ = nullptr;
  std::vector<ChangeBound> change_bounds_;
  std::vector<ConstraintName> soft_constraints_;
  std::array<Twist2, kMaxHorizon> commands_;  // at the point read last
  std::array<Pose2, kMaxHorizon + 1>
      poses_{};  // at the point read last; variables, not the rollout
  ConstraintName limiting_;
};

}  // namespace fairway
