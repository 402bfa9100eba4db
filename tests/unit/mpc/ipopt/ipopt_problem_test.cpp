// SPDX-License-Identifier: Apache-2.0
#include "fairway/mpc/ipopt/ipopt_problem.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "fairway/mpc/evaluation.hpp"
#include "support/oracles/central_difference.hpp"
#include "support/random/random_control_problem.hpp"

namespace fairway {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Ipopt::Index;

// Calls a TNLP like IPOPT and returns dense matrices.
class DenseView {
 public:
  explicit DenseView(IpoptProblem& nlp) : nlp_(&nlp) {
    Ipopt::TNLP::IndexStyleEnum style{};
    EXPECT_TRUE(nlp.get_nlp_info(n, m, jacobian_size_, hessian_size_, style));
  }

  VectorXd cost_gradient(const VectorXd& x) {
    VectorXd gradient(n);
    nlp_->eval_grad_f(n, x.data(), true, gradient.data());
    return gradient;
  }
  double cost(const VectorXd& x) {
    double value = 0.0;
    nlp_->eval_f(n, x.data(), true, value);
    return value;
  }
  VectorXd constraints(const VectorXd& x) {
    VectorXd g(m);
    nlp_->eval_g(n, x.data(), true, m, g.data());
    return g;
  }
  MatrixXd jacobian(const VectorXd& x) {
    std::vector<Index> row(static_cast<std::size_t>(jacobian_size_));
    std::vector<Index> column(row);
    std::vector<double> value(row.size());
    nlp_->eval_jac_g(n, nullptr, false, m, jacobian_size_, row.data(), column.data(), nullptr);
    nlp_->eval_jac_g(n, x.data(), true, m, jacobian_size_, nullptr, nullptr, value.data());
    MatrixXd dense = MatrixXd::Zero(m, n);
    for (std::size_t i = 0; i < row.size(); ++i)
      dense(row[i], column[i]) += value[i];
    return dense;
  }
  MatrixXd hessian(const VectorXd& x, double factor, const VectorXd& lambda) {
    std::vector<Index> row(static_cast<std::size_t>(hessian_size_));
    std::vector<Index> column(row);
    std::vector<double> value(row.size());
    nlp_->eval_h(n, nullptr, false, factor, m, lambda.data(), false, hessian_size_, row.data(),
                 column.data(), nullptr);
    nlp_->eval_h(n, x.data(), true, factor, m, lambda.data(), true, hessian_size_, nullptr, nullptr,
                 value.data());
    MatrixXd dense = MatrixXd::Zero(n, n);
    for (std::size_t i = 0; i < row.size(); ++i) {
      EXPECT_GE(row[i], column[i]) << "lower triangle";
      dense(row[i], column[i]) += value[i];
      if (row[i] != column[i]) dense(column[i], row[i]) += value[i];
    }
    return dense;
  }

  Index n = 0;
  Index m = 0;

 private:
  IpoptProblem* nlp_;
  Index jacobian_size_ = 0;
  Index hessian_size_ = 0;
};

class IpoptProblemDerivatives : public testing::TestWithParam<IpoptConstraints> {};

TEST_P(IpoptProblemDerivatives, AgreeWithDifferences) {
  test::Random random(41);
  for (int trial = 0; trial < 30; ++trial) {
    const ControlProblem problem =
        test::random_control_problem(random, {.max_horizon = 6, .max_obstacles = 3});
    std::array<Twist2, kMaxHorizon> start{};
    expand_guess(problem, {}, start);
    IpoptProblem nlp(GetParam());
    nlp.set(problem, start);
    DenseView view(nlp);
    VectorXd x(view.n);
    for (double& value : x)
      value = random.uniform(-1.0, 1.0);
    VectorXd lambda(view.m);
    for (double& value : lambda)
      value = random.uniform(-1.0, 1.0);

    const VectorXd gradient =
        test::central_difference(
            [&](const VectorXd& z) { return VectorXd(VectorXd::Constant(1, view.cost(z))); }, x)
            .row(0);
    // The penalty makes the cost large, and differences less accurate.
    EXPECT_LT((view.cost_gradient(x) - gradient).cwiseAbs().maxCoeff(),
              1e-9 * (1.0 + std::abs(view.cost(x))) / 1e-3);
    const MatrixXd jacobian =
        test::central_difference([&](const VectorXd& z) { return view.constraints(z); }, x);
    EXPECT_LT((view.jacobian(x) - jacobian).cwiseAbs().maxCoeff(), 1e-7);
    const auto lagrangian_gradient = [&](const VectorXd& z) {
      return VectorXd(0.5 * view.cost_gradient(z) + view.jacobian(z).transpose() * lambda);
    };
    const MatrixXd hessian = test::central_difference(lagrangian_gradient, x);
    EXPECT_LT((view.hessian(x, 0.5, lambda) - hessian).cwiseAbs().maxCoeff(), 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Rows,
                         IpoptProblemDerivatives,
                         testing::Values(IpoptConstraints::Soft, IpoptConstraints::Hard));

}  // namespace
}  // namespace fairway
