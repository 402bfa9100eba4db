// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/studies/sample_statistics.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace fairway::reproduction {
namespace {

// Student's own data (Biometrika 1908): extra hours of sleep of ten people with two drugs. The
// expected numbers are those of R's t.test.
const std::vector<double> kFirst = {0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const std::vector<double> kSecond = {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

TEST(SampleStatistics, WelchTestAgreesWithAPublishedExample) {
  const TestResult test = welch_test(kFirst, kSecond);
  EXPECT_NEAR(test.t, -1.8608, 5e-5);
  EXPECT_NEAR(test.degrees, 17.776, 5e-4);
  EXPECT_NEAR(test.p, 0.07939, 5e-6);
}

TEST(SampleStatistics, WelchTestAgreesWithTheClosedFormOfTwoDegreesOfFreedom) {
  // Both means have variance 1, so t = -3 / sqrt(2); P(|T| > t) = 1 - t / sqrt(2 + t^2).
  const std::vector<double> a = {0.0, 2.0};
  const std::vector<double> b = {3.0, 5.0};
  const TestResult test = welch_test(a, b);
  const double t = 3.0 / std::sqrt(2.0);
  EXPECT_NEAR(test.t, -t, 1e-12);
  EXPECT_NEAR(test.degrees, 2.0, 1e-12);
  EXPECT_NEAR(test.p, 1.0 - t / std::sqrt(2.0 + t * t), 1e-12);
}

TEST(SampleStatistics, WelchTestIsSymmetric) {
  const TestResult one = welch_test(kFirst, kSecond);
  const TestResult other = welch_test(kSecond, kFirst);
  EXPECT_EQ(one.t, -other.t);
  EXPECT_EQ(one.p, other.p);
}

TEST(SampleStatistics, PairedTestAgreesWithAPublishedExample) {
  const TestResult test = paired_test(kFirst, kSecond);
  EXPECT_NEAR(test.t, -4.0621, 5e-5);
  EXPECT_EQ(test.degrees, 9.0);
  EXPECT_NEAR(test.p, 0.002833, 5e-7);
}

TEST(SampleStatistics, IntervalAgreesWithAPublishedExample) {
  const Estimate e = estimate(differences(kSecond, kFirst));
  EXPECT_EQ(e.count, 10);
  EXPECT_NEAR(e.mean, 1.58, 1e-12);
  EXPECT_NEAR(e.low, 0.7001142, 5e-8);
  EXPECT_NEAR(e.high, 2.4598858, 5e-8);
}

TEST(SampleStatistics, SmallAndConstantSamplesGiveDefinedResults) {
  const std::vector<double> none;
  const std::vector<double> one = {3.0};
  const std::vector<double> same = {3.0, 3.0, 3.0};
  const std::vector<double> higher = {4.0, 4.0, 4.0};
  EXPECT_EQ(estimate(none).count, 0);
  EXPECT_EQ(estimate(one).low, 3.0);
  EXPECT_EQ(estimate(one).high, 3.0);
  EXPECT_EQ(welch_test(one, same).p, 1.0);
  EXPECT_EQ(welch_test(same, same).p, 1.0);
  EXPECT_EQ(welch_test(same, higher).p, 0.0);
  EXPECT_EQ(paired_test(same, same).p, 1.0);
  EXPECT_EQ(paired_test(same, higher).p, 0.0);
}

TEST(SampleStatistics, MarksAreThoseOfThePaper) {
  EXPECT_EQ(significance_mark(0.2), "*");
  EXPECT_EQ(significance_mark(0.05), "**");
  EXPECT_EQ(significance_mark(0.01), "***");
  EXPECT_EQ(significance_mark(0.001), "****");
}

TEST(SampleStatistics, PercentagesAreRelativeToTheSecond) {
  const std::vector<double> a = {30.0, 12.0};
  const std::vector<double> b = {52.0, 17.0};
  const std::vector<double> change = percent_over(a, b);
  EXPECT_NEAR(change[0], -42.31, 0.005);
  EXPECT_NEAR(change[1], -29.41, 0.005);
  // The paper's "-35.86 %" is their mean.
  EXPECT_NEAR(estimate(change).mean, -35.86, 0.005);
}

}  // namespace
}  // namespace fairway::reproduction
