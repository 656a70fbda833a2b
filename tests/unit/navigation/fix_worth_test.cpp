// SPDX-License-Identifier: MIT
#include "estimation/navigation/fix_worth.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr double kCorrelation = 120.0;

Eigen::MatrixXd CovarianceOf(const std::vector<double>& times) {
  const auto n = static_cast<Eigen::Index>(times.size());
  Eigen::MatrixXd covariance(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const double apart = times[static_cast<std::size_t>(i)] - times[static_cast<std::size_t>(k)];
      covariance(i, k) = std::exp(-std::abs(apart) / kCorrelation);
    }
  }
  return covariance;
}

/// Of a place from fixes whose error is a Gauss-Markov process of unit variance.
double Information(const std::vector<double>& times) {
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(times.size()));
  return ones.dot(CovarianceOf(times).llt().solve(ones));
}

std::vector<double> EverySecond(double from, double to) {
  std::vector<double> times;
  for (double t = from; t <= to; t += 1.0)
    times.push_back(t);
  return times;
}

Eigen::VectorXd WorthsOf(const FixRow& row) {
  Eigen::VectorXd worths(static_cast<Eigen::Index>(row.times.size()));
  for (std::size_t i = 0; i < row.times.size(); ++i)
    worths(static_cast<Eigen::Index>(i)) = row.WorthOf(i);
  return worths;
}

TEST(FixWorth, OfALoneFixIsWhatItSays) { EXPECT_DOUBLE_EQ(FixRow{.times = {5.0}}.WorthOf(0), 1.0); }

TEST(FixWorth, OfAllIsTheInformationOfAnErrorThatWanders) {
  for (const double length : {1.0, 6.0, 60.0, 600.0}) {
    const FixRow row{.times = EverySecond(0.0, length)};
    EXPECT_NEAR(WorthsOf(row).sum(), Information(row.times), 1e-6) << length << " s";
    EXPECT_NEAR(WorthsOf(row).sum(), 1.0 + length / (2.0 * kCorrelation), 1e-3) << length << " s";
  }
}

TEST(FixWorth, OfUnevenFixesToo) {
  const FixRow row{.times = {0.0, 1.0, 2.0, 2.5, 10.0, 80.0, 81.0, 400.0, 401.0, 402.0, 403.0}};
  EXPECT_NEAR(WorthsOf(row).sum(), Information(row.times), 1e-6);
}

TEST(FixWorth, OfALaterStayIsLessForWhatBothHaveInCommon) {
  for (const double gap : {61.0, 200.0, 2000.0}) {
    const std::vector<double> before = EverySecond(0.0, 50.0);
    const FixRow row{.gap_before = gap, .times = EverySecond(50.0 + gap, 100.0 + gap)};
    std::vector<double> both = before;
    both.insert(both.end(), row.times.begin(), row.times.end());
    EXPECT_NEAR(WorthsOf(FixRow{.times = before}).sum() + WorthsOf(row).sum(), Information(both),
                1e-6)
        << gap << " s";
  }
}

TEST(FixWorth, WeighsAsWellAsCanBe) {
  const FixRow row{.times = EverySecond(0.0, 60.0)};
  const Eigen::VectorXd weights = WorthsOf(row) / WorthsOf(row).sum();
  const double variance = weights.dot(CovarianceOf(row.times) * weights);
  EXPECT_LT(variance, 1.02 / Information(row.times));
}

TEST(FixWorth, OfNoSingleFixDecidesWhereAVehicleIs) {
  EXPECT_LT(WorthsOf(FixRow{.times = EverySecond(0.0, 60.0)}).maxCoeff(), 0.08);
}

TEST(FixWorth, IsTakenAnewWhereverAnotherFixChangesIt) {
  FixRow row{.times = {0.0}};
  for (double t = 1.0; t < 25.0; t += 1.0) {
    const Eigen::VectorXd before = WorthsOf(row);
    row.times.push_back(t);
    for (std::size_t i = 0; i < row.FirstChangedByTheLast(); ++i)
      EXPECT_DOUBLE_EQ(row.WorthOf(i), before(static_cast<Eigen::Index>(i))) << i;
  }
}

}  // namespace
}  // namespace limpet
