// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/studies/sample_statistics.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include <boost/math/distributions/complement.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/statistics/t_test.hpp>

#include "fairway/base/contract.hpp"

namespace fairway::reproduction {

namespace {

using boost::math::complement;
using boost::math::students_t;

double mean_of(std::span<const double> sample) {
  double sum = 0.0;
  for (const double value : sample)
    sum += value;
  return sum / static_cast<double>(sample.size());
}

double variance_of(std::span<const double> sample, double mean) {
  double sum = 0.0;
  for (const double value : sample)
    sum += (value - mean) * (value - mean);
  return sum / static_cast<double>(sample.size() - 1);
}

// Both samples are constant, so the result is certain.
TestResult certain(double difference) {
  if (difference == 0.0) return {};
  return {.t = std::copysign(std::numeric_limits<double>::max(), difference), .p = 0.0};
}

}  // namespace

Estimate estimate(std::span<const double> sample) {
  Estimate result{.count = static_cast<int>(sample.size())};
  if (sample.empty()) return result;
  result.mean = result.low = result.high = mean_of(sample);
  if (sample.size() < 2) return result;
  const auto n = static_cast<double>(sample.size());
  result.deviation = std::sqrt(variance_of(sample, result.mean));
  const double t = boost::math::quantile(complement(students_t(n - 1.0), 0.025));
  const double half = t * result.deviation / std::sqrt(n);
  result.low = result.mean - half;
  result.high = result.mean + half;
  return result;
}

TestResult welch_test(std::span<const double> a, std::span<const double> b) {
  if (a.size() < 2 || b.size() < 2) return {};
  const double mean_a = mean_of(a);
  const double mean_b = mean_of(b);
  // Variances of the two means; Welch and Satterthwaite's degrees of freedom.
  const auto na = static_cast<double>(a.size());
  const auto nb = static_cast<double>(b.size());
  const double va = variance_of(a, mean_a) / na;
  const double vb = variance_of(b, mean_b) / nb;
  if (va + vb == 0.0) return certain(mean_a - mean_b);
  TestResult result;
  result.t = (mean_a - mean_b) / std::sqrt(va + vb);
  result.degrees = (va + vb) * (va + vb) / (va * va / (na - 1.0) + vb * vb / (nb - 1.0));
  result.p = 2.0 * boost::math::cdf(complement(students_t(result.degrees), std::abs(result.t)));
  return result;
}

TestResult paired_test(std::span<const double> a, std::span<const double> b) {
  const std::vector<double> d = differences(a, b);
  if (d.size() < 2) return {};
  const double mean = mean_of(d);
  const double variance = variance_of(d, mean);
  if (variance == 0.0) return certain(mean);
  const auto n = static_cast<double>(d.size());
  const auto [t, p] = boost::math::statistics::one_sample_t_test(mean, variance, n, 0.0);
  return {.t = t, .degrees = n - 1.0, .p = p};
}

std::string significance_mark(double p) {
  if (p > 0.05) return "*";
  if (p > 0.01) return "**";
  return p > 0.001 ? "***" : "****";
}

std::vector<double> differences(std::span<const double> a, std::span<const double> b) {
  FAIRWAY_EXPECTS(a.size() == b.size());
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    result[i] = a[i] - b[i];
  return result;
}

std::vector<double> percent_over(std::span<const double> a, std::span<const double> b) {
  FAIRWAY_EXPECTS(a.size() == b.size());
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    result[i] = 100.0 * (a[i] / b[i] - 1.0);
  return result;
}

}  // namespace fairway::reproduction
