// SPDX-License-Identifier: MIT
#include "limpet/console/rate_estimate.hpp"

#include <algorithm>

namespace limpet {
namespace {

constexpr Seconds kWindow(8.0);
constexpr Seconds kMarkEvery(0.25);

}  // namespace

void RateEstimate::Note(Seconds now) {
  ++events_;
  last_ = now;
  if (!marks_.empty() && now == marks_.back().time) {
    marks_.back().events = events_;  // they came together: none of them lies after the mark
  }
  if (marks_.empty() || now - marks_.back().time >= kMarkEvery) {
    marks_.push_back({now, events_});
  }
  while (marks_.size() > 2 && now - marks_[1].time >= kWindow) {
    marks_.pop_front();
  }
}

double RateEstimate::At(Seconds now) const {
  if (events_ < 2) {
    return 0.0;
  }
  const auto count = static_cast<double>(events_ - marks_.front().events);
  double span = (last_ - marks_.front().time).value();
  const double overdue = (now - last_).value() - (count > 0.0 ? span / count : 0.0);
  span += std::max(0.0, overdue);
  return span > 0.0 ? count / span : 0.0;
}

}  // namespace limpet
