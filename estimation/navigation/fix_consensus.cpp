// SPDX-License-Identifier: MIT
#include "estimation/navigation/fix_consensus.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "limpet/core/statistics.hpp"

namespace limpet {
namespace {

constexpr double kStayGap = 60.0;          // [s] without a fix that end a stay
constexpr double kSameSigmas = 3.0;        // of the difference of two fixes of one group
constexpr double kSameLeast = 0.5;         // [m] that dead reckoning may drift meanwhile
constexpr double kLatestShare = 0.3;       // of a fix in where its group is now
constexpr double kPredictionGate = 5.0;    // off the prediction
constexpr double kPredictionWorth = 20.0;  // [s] of fixes that refute it
constexpr double kReturnWorth = 10.0;      // [s] of fixes that a return to a group is worth
constexpr double kSupportScale = 5.0;      // [s] more of fixes make a group e times as likely
constexpr double kLead = 5.0;              // [s] that another group must have in hand
constexpr double kLongestStep = 2.0;       // [s] from one fix to the next that count
constexpr double kMostSupport = 120.0;     // [s]: so old a group can be refuted, too
constexpr std::size_t kFewest = 5;         // fixes that make a group worth believing against others
constexpr std::size_t kLatestSteps = 31;
constexpr double kSameSteps = 5.0;  // usual ones that a fix of a group lies off it

}  // namespace

bool FixConsensus::IsNewStay(double t) const { return t - last_t_ > kStayGap; }

void FixConsensus::BeginStay(const std::optional<FixPrediction>& prediction, double scale) {
  prediction_ = prediction;
  scale_ = scale;
  groups_.clear();
  believed_.reset();
  added_ = 0;
}

bool FixConsensus::IsAsPredicted(const HeldFix& held) const {
  if (!prediction_) return true;
  const double sd = scale_ * held.fix.sd;
  const Eigen::Matrix2d S = prediction_->covariance_W + sd * sd * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d r = held.off_W - prediction_->off_W;
  return r.dot(S.llt().solve(r)) <= kPredictionGate * kPredictionGate;
}

FixConsensus::Group& FixConsensus::GroupOf(const HeldFix& held) {
  const auto distance = [&](const Group& group) { return (group.off_W - held.off_W).norm(); };
  const auto nearest = std::ranges::min_element(groups_, {}, distance);
  const double same =
      std::max({kSameLeast, kSameSigmas * std::sqrt(2.0) * held.fix.sd, kSameSteps * usual_step_});
  if (nearest != groups_.end() && distance(*nearest) <= same) return *nearest;
  groups_.push_back({.fixes = {}, .off_W = held.off_W, .is_predicted = IsAsPredicted(held)});
  return groups_.back();
}

void FixConsensus::NoteStep(const HeldFix& held) {
  if (added_ > 0 && held.fix.t - last_t_ <= kLongestStep) {
    steps_.push_back((held.off_W - last_off_W_).norm());
    if (steps_.size() > kLatestSteps) steps_.pop_front();
    usual_step_ = steps_.size() < kFewest
                      ? 0.0
                      : UpperMedian(std::vector<double>(steps_.begin(), steps_.end()));
  }
  last_off_W_ = held.off_W;
}

double FixConsensus::SupportOf(const Group& group) const {
  return group.support + (group.is_predicted ? kPredictionWorth : 0.0);
}

bool FixConsensus::IsBetter(const Group& rival) const {
  if (believed_) {
    return rival.fixes.size() >= kFewest &&
           SupportOf(rival) > SupportOf(groups_[*believed_]) + kLead;
  }
  return rival.is_predicted || (rival.fixes.size() >= kFewest && rival.support > kPredictionWorth);
}

FixConsensus::Verdict FixConsensus::Add(const HeldFix& held) {
  NoteStep(held);
  Group& group = GroupOf(held);
  const auto number = static_cast<std::size_t>(&group - groups_.data());
  const bool comes_back = group.last && *group.last + 1 < added_;
  const double step =
      group.fixes.empty() ? 0.0 : std::min(held.fix.t - group.fixes.back().fix.t, kLongestStep);
  group.support = std::min(group.support + step + (comes_back ? kReturnWorth : 0.0), kMostSupport);
  group.last = added_;
  group.fixes.push_back(held);
  const double share = std::max(1.0 / static_cast<double>(group.fixes.size()), kLatestShare);
  group.off_W += share * (held.off_W - group.off_W);
  last_t_ = held.fix.t;
  ++added_;
  if (believed_ == number) return {.is_believed = true, .has_changed_group = false};
  if (!IsBetter(group)) return {};
  const bool has_changed = believed_.has_value() || group.fixes.size() > 1;
  believed_ = number;
  return {.is_believed = true, .has_changed_group = has_changed};
}

const std::vector<HeldFix>& FixConsensus::believed() const {
  static const std::vector<HeldFix> none;
  return believed_ ? groups_[*believed_].fixes : none;
}

double FixConsensus::DoubtVariance() const {
  if (!believed_) return 0.0;
  const Group& best = groups_[*believed_];
  double sum = 1.0, variance = 0.0;
  for (const Group& group : groups_) {
    if (&group == &best || group.fixes.size() < kFewest) continue;
    const double odds = std::exp((SupportOf(group) - SupportOf(best)) / kSupportScale);
    sum += odds;
    variance += odds * 0.5 * (group.off_W - best.off_W).squaredNorm();
  }
  return variance / sum;
}

}  // namespace limpet
