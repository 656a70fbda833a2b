// SPDX-License-Identifier: MIT
#include "estimation/navigation/aiding_sources.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation.h>

#include "estimation/smoothing/factors/border_prior_factor.hpp"

namespace limpet {
namespace {

constexpr int kBelieveAfter = 10;  // refused in a row, then taken after all
constexpr double kGateSigmas = 5.0;
/// No estimate is that much worse than it says: what is further off is the source's own fault,
/// however often it says so.
constexpr double kMostSigmas = 25.0;
constexpr std::size_t kLongestQueue = 4096;  // observations that wait: a source gone wild

}  // namespace

int AidingSources::Add(std::unique_ptr<MeasurementSource> source) {
  entries_.push_back({.source = std::move(source),
                      .errors = std::nullopt,
                      .gate = PersistenceGate(kBelieveAfter),
                      .counts = {}});
  return size() - 1;
}

void AidingSources::Begin() {
  for (Entry& entry : entries_) {
    const auto errors = entry.source->Errors();
    if (!errors) continue;
    entry.errors = smoother_.AddSensorErrors(Eigen::Vector3d::Zero());
    const Eigen::Matrix3d covariance = errors->sigma.cwiseAbs2().asDiagonal();
    smoother_.AddBorderTerm(
        *entry.errors,
        Term::OnBorder(BorderPriorFactor(Eigen::Vector3d::Zero(), covariance), *entry.errors));
  }
}

void AidingSources::Keep(int source, std::shared_ptr<mrpt::obs::CObservation> seen) {
  const double t = mrpt::Clock::toDouble(seen->timestamp);
  if (waiting_.size() >= kLongestQueue) {
    ++At(source).counts.late;
    return;
  }
  const auto after = std::ranges::upper_bound(waiting_, t, {}, &Waiting::t);
  waiting_.insert(after, {.t = t, .source = source, .seen = std::move(seen)});
}

std::optional<double> AidingSources::NextTime() const {
  return waiting_.empty() ? std::nullopt : std::optional(waiting_.front().t);
}

void AidingSources::Drop() {
  ++At(waiting_.front().source).counts.late;
  waiting_.pop_front();
}

std::optional<AidingSources::Offer> AidingSources::Take() {
  const Waiting next = std::move(waiting_.front());
  waiting_.pop_front();
  Entry& entry = At(next.source);
  std::optional<Term> term = entry.source->Measure(*next.seen, entry.errors.value_or(-1));
  if (!term) {
    ++entry.counts.unused;
    return std::nullopt;
  }
  return Offer{.source = next.source, .term = *std::move(term)};
}

bool AidingSources::Use(Offer offer, int node) {
  Entry& entry = At(offer.source);
  const double misfit = Misfit(offer.term);
  if (!(misfit <= kMostSigmas) || !entry.gate.Accepts(misfit <= kGateSigmas)) {
    ++entry.counts.refused;
    ++entry.counts.refused_in_row;
    return false;
  }
  entry.counts.refused_in_row = 0;
  ++entry.counts.taken;
  smoother_.AddTerm(node, std::move(offer.term));
  smoother_.Update();
  return entry.source->is_fix();
}

double AidingSources::Misfit(const Term& term) const {
  const std::vector<int> slots(term.slots().begin(), term.slots().end());
  const NavVector x = smoother_.PoseAt(smoother_.graph().node_count() - 1);
  std::array<Eigen::Vector3d, kMostBorders> errors;
  TermPoint at{.pose = &x};
  for (std::size_t i = 0; i < slots.size(); ++i) {
    errors[i] = smoother_.BorderAt(slots[i]);
    at.border[i] = &errors[i];
  }
  LinearTerm linear;
  term.Linearize(at, linear);
  const Eigen::MatrixXd covariance = smoother_.Covariance(slots);
  Eigen::MatrixXd J(linear.rows, covariance.rows());
  J.leftCols<6>() = linear.J_pose.topRows(linear.rows);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    J.middleCols<3>(static_cast<Eigen::Index>(6 + 3 * i)) = linear.J_border[i].topRows(linear.rows);
  }
  const Eigen::MatrixXd S =
      J * covariance * J.transpose() + Eigen::MatrixXd::Identity(linear.rows, linear.rows);
  const Eigen::VectorXd r = linear.r.head(linear.rows);
  return std::sqrt(r.dot(S.llt().solve(r)));
}

std::optional<SourceErrorEstimate> AidingSources::ErrorsOf(int i) const {
  if (!At(i).errors) return std::nullopt;
  const int slot = *At(i).errors;
  const Eigen::MatrixXd covariance = smoother_.Covariance({slot});
  return SourceErrorEstimate{.value = smoother_.BorderAt(slot),
                             .sd = covariance.diagonal().tail<3>().cwiseMax(0.0).cwiseSqrt()};
}

std::vector<NamedState> AidingSources::NamedErrorsOf(int i) const {
  std::vector<NamedState> named;
  const auto known = source(i).Errors();
  const auto now = ErrorsOf(i);
  for (std::size_t k = 0; known && now && k < known->names.size(); ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    named.push_back({known->names[k], now->value(axis), now->sd(axis)});
  }
  return named;
}

}  // namespace limpet
