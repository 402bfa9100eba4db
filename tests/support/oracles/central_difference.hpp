// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace fairway::test {

/// Jacobian of `function` (VectorXd to VectorXd) at `x` by central differences. With steps of 1e-6
/// and values of order 1 the error is about 1e-9.
template <typename Function>
Eigen::MatrixXd central_difference(Function&& function,
                                   const Eigen::VectorXd& x,
                                   double step = 1e-6) {
  const Eigen::VectorXd value = function(x);
  Eigen::MatrixXd jacobian(value.size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd ahead = x;
    Eigen::VectorXd behind = x;
    ahead[i] += step;
    behind[i] -= step;
    jacobian.col(i) = (function(ahead) - function(behind)) / (ahead[i] - behind[i]);
  }
  return jacobian;
}

}  // namespace fairway::test
