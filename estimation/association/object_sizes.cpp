// SPDX-License-Identifier: MIT
#include "estimation/association/object_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/smoothing/factors/shared_prior_factor.hpp"

namespace limpet {

std::optional<SizeSlot> ObjectSizes::Take(double believed) {
  if (!(*spread_ > 0.0)) return std::nullopt;
  constexpr int kSizes = 3;  // in one variable
  if (!next_ || next_->index == kSizes) {
    next_ = SizeSlot{.slot = smoother_->AddObjectSizes(Eigen::Vector3d::Zero())};
    // The linear tails of the loss let a size be quite another.
    for (int i = 0; i < kSizes; ++i) {
      smoother_->AddBorderTerm(next_->slot, Term::OnBorder(SharedPriorFactor(i, spread_),
                                                           next_->slot, Loss::Huber(1.0)));
    }
  }
  SizeSlot taken = *next_;
  taken.believed = believed;
  ++next_->index;
  return taken;
}

void ObjectSizes::Learn(const std::vector<SizeSlot>& seen) {
  if (!(*spread_ > 0.0) || seen.size() == learnt_from_) return;
  learnt_from_ = seen.size();
  // What is not known of a size leaves the spread as it is: its variance is the spread's own.
  constexpr double kBelieved = 4.0;  // objects that the stated spread is worth
  double sum = kBelieved * stated_spread_ * stated_spread_;
  for (const SizeSlot& size : seen) {
    if (smoother_->IsAtHand(size.slot) || !variances_.contains(size.slot))
      variances_.insert_or_assign(size.slot, Variances(size.slot));
    sum += std::pow(smoother_->BorderAt(size.slot)(size.index), 2) +
           std::max(variances_.at(size.slot)(size.index), 0.0);
  }
  *spread_ = std::sqrt(sum / (kBelieved + static_cast<double>(seen.size())));
}

double ObjectSizes::VarianceOf(const SizeSlot& size) const {
  const auto known = variances_.find(size.slot);
  const bool is_known = known != variances_.end() && !smoother_->IsAtHand(size.slot);
  return std::max((is_known ? known->second : Variances(size.slot))(size.index), 0.0);
}

Eigen::Vector3d ObjectSizes::Variances(int slot) const {
  return smoother_->Covariance({slot}).diagonal().tail<3>();
}

}  // namespace limpet
