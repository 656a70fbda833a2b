// SPDX-License-Identifier: MIT
// The most likely shape of a Gaussian process: hill climbing over the logarithms of its lengths and
// of its signal, one at a time, with steps that halve.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "limpet/core/require.hpp"
#include "limpet/tuning/gaussian_process.hpp"

namespace limpet {
namespace {

constexpr double kShortestLength = 0.05, kLongestLength = 20.0, kSignalRange = 10.0;
constexpr double kFirstStep = 1.0, kLastStep = 0.02;
constexpr int kMostSweeps = 20;  // with one step's size

double SpreadOf(const std::vector<ProcessSample>& samples) {
  double sum = 0.0, squares = 0.0;
  for (const ProcessSample& sample : samples) {
    sum += sample.y;
    squares += sample.y * sample.y;
  }
  const auto count = static_cast<double>(samples.size());
  const double variance = squares / count - (sum / count) * (sum / count);
  return variance > 0.0 ? std::sqrt(variance) : 1.0;
}

class ShapeClimb {
 public:
  explicit ShapeClimb(const std::vector<ProcessSample>& samples)
      : samples_(samples),
        lengths_(samples.front().x.size()),
        low_(Eigen::VectorXd::Constant(lengths_ + 1, std::log(kShortestLength))),
        high_(Eigen::VectorXd::Constant(lengths_ + 1, std::log(kLongestLength))) {
    const double spread = SpreadOf(samples);
    low_(lengths_) = std::log(spread / kSignalRange);
    high_(lengths_) = std::log(spread * kSignalRange);
  }

  [[nodiscard]] ProcessShape ShapeOf(const Eigen::VectorXd& logs) const {
    return {.length = logs.head(lengths_).array().exp(), .signal = std::exp(logs(lengths_))};
  }

  /// Where the climb from equal lengths ends, and how likely the samples are there.
  [[nodiscard]] std::pair<Eigen::VectorXd, double> From(double length) const {
    Eigen::VectorXd logs = Eigen::VectorXd::Constant(lengths_ + 1, std::log(length));
    logs(lengths_) = 0.5 * (low_(lengths_) + high_(lengths_));
    double likelihood = LikelihoodOf(logs);
    for (double step = kFirstStep; step > kLastStep; step *= 0.5) {
      int sweeps = 0;
      while (sweeps < kMostSweeps && Sweep(step, logs, likelihood))
        ++sweeps;
    }
    return {logs, likelihood};
  }

 private:
  [[nodiscard]] double LikelihoodOf(const Eigen::VectorXd& logs) const {
    return GaussianProcess(samples_, ShapeOf(logs)).LogLikelihood();
  }

  /// Tries a step either way along each axis; true if one led up.
  [[nodiscard]] bool Sweep(double step, Eigen::VectorXd& logs, double& likelihood) const {
    bool has_risen = false;
    for (Eigen::Index i = 0; i <= lengths_; ++i) {
      for (const double move : {step, -step}) {
        Eigen::VectorXd moved = logs;
        moved(i) = std::clamp(moved(i) + move, low_(i), high_(i));
        const double there = LikelihoodOf(moved);
        if (there <= likelihood) continue;
        logs = moved;
        likelihood = there;
        has_risen = true;
      }
    }
    return has_risen;
  }

  const std::vector<ProcessSample>& samples_;
  Eigen::Index lengths_;
  Eigen::VectorXd low_, high_;
};

}  // namespace

GaussianProcess GaussianProcess::Fitted(const std::vector<ProcessSample>& samples) {
  LIMPET_REQUIRE(!samples.empty(), "a process without samples");
  const ShapeClimb climb(samples);
  std::pair<Eigen::VectorXd, double> best{{}, -std::numeric_limits<double>::infinity()};
  for (const double length : {0.2, 0.6, 3.0}) {
    std::pair<Eigen::VectorXd, double> end = climb.From(length);
    if (best.first.size() == 0 || end.second > best.second) best = std::move(end);
  }
  return {samples, climb.ShapeOf(best.first)};
}

}  // namespace limpet
