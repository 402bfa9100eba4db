// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

namespace fairway::reproduction {

/// A sample's mean with its 95 % confidence interval.
struct Estimate {
  int count = 0;
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation, from count - 1
  double low = 0.0;        ///< ends of the interval by Student's t; the mean itself for fewer than
                           ///< 2 values
  double high = 0.0;

  [[nodiscard]] double half_width() const noexcept { return 0.5 * (high - low); }
};

[[nodiscard]] Estimate estimate(std::span<const double> sample);

/// The result of a test of equal means.
struct TestResult {
  double t = 0.0;        ///< the statistic
  double degrees = 0.0;  ///< of freedom
  double p = 1.0;        ///< probability of a difference at least this large if the means were
                         ///< equal
};

/// Welch's two-sample t-test, two-sided: samples may differ in size and variance. The distribution
/// is Boost.Math's Student t. Samples of fewer than two values give p = 1; two constant samples
/// give p = 1 if they are equal and else p = 0.
[[nodiscard]] TestResult welch_test(std::span<const double> a, std::span<const double> b);

/// The paired t-test, two-sided: Boost.Math's one-sample test of the differences a - b against 0.
/// It is for values in pairs, here from the same map. @pre samples of the same size.
[[nodiscard]] TestResult paired_test(std::span<const double> a, std::span<const double> b);

/// The marks of the paper's Figure 10: * not significant (p > 0.05), ** p <= 0.05, *** p <= 0.01,
/// **** p <= 0.001.
[[nodiscard]] std::string significance_mark(double p);

/// a[i] - b[i]. @pre samples of the same size.
[[nodiscard]] std::vector<double> differences(std::span<const double> a, std::span<const double> b);

/// 100 (a[i] / b[i] - 1): the relative excess of a over b [%]. @pre samples of the same size.
[[nodiscard]] std::vector<double> percent_over(std::span<const double> a,
                                               std::span<const double> b);

}  // namespace fairway::reproduction
