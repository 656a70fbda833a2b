// SPDX-License-Identifier: MIT
#include "estimation/change/look_log.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/change/log_space.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

PerVisibility LogChance(const PerVisibility& chance, bool has_box) {
  return chance.unaryExpr([has_box](double value) {
    const double p = std::clamp(value, 1e-6, 1.0 - 1e-6);
    return has_box ? std::log(p) : std::log1p(-p);
  });
}

}  // namespace

LookLog::Evidence& LookLog::Evidence::operator+=(const Evidence& other) {
  present += other.present;
  present_failing += other.present_failing;
  absent += other.absent;
  absent_clutter += other.absent_clutter;
  return *this;
}

LookLog::Evidence LookLog::Evidence::operator/(double n) const {
  return {present / n, present_failing / n, absent / n, absent_clutter / n};
}

LookLog::Evidence LookLog::Weigh(const FrameEvidence& frame) const {
  // A false alarm can fall on an object that the detector missed, so presence never has less chance
  // of a box than absence.
  const auto either = [&frame](const PerVisibility& detects) {
    return PerVisibility(1.0 - (1.0 - detects) * (1.0 - frame.false_alarm));
  };
  const PerVisibility clutter = params_.clutter_detects * frame.detects;
  return {
      .present = LogChance(either(frame.detects), frame.has_box),
      .present_failing = LogChance(either(params_.failing_detects * frame.detects), frame.has_box),
      .absent = LogChance(frame.false_alarm, frame.has_box),
      .absent_clutter = LogChance(either(clutter), frame.has_box)};
}

bool LookLog::IsNewViewpoint(const FrameEvidence& frame) const {
  const double moved = (frame.p_OC - look_->p_OC).norm();
  const double cosine = frame.p_OC.normalized().dot(look_->p_OC.normalized());
  return moved >= params_.new_look_distance.value() ||
         cosine <= std::cos(params_.new_look_angle.value());
}

void LookLog::Add(const FrameEvidence& frame) {
  LIMPET_REQUIRE(!look_ || frame.time >= last_time_, "frames out of order");
  if (look_ && frame.time - last_time_ > params_.new_pass_gap.value()) {
    ClosePass();
  } else if (look_ && IsNewViewpoint(frame)) {
    CloseLook();
  }
  last_time_ = frame.time;
  if (!look_) {
    look_ = Look{.p_OC = frame.p_OC, .sum = {}};
    passes_ += pass_ ? 0 : 1;
    pass_ = pass_.value_or(Evidence{});
  }
  look_->sum += Weigh(frame);
  look_->detects += frame.detects;
  look_->has_box = look_->has_box || frame.has_box;
  ++look_->frames;
}

PerVisibility LookLog::Look::counts() const {
  const double least = has_box ? 0.0 : kLookChance * frames;
  return detects.unaryExpr([least](double chances) { return chances >= least ? 1.0 : 0.0; });
}

void LookLog::CloseLook() {
  *pass_ += look_->mean();
  closed_looks_ += look_->counts();
  closed_looks_with_box_ += look_->has_box ? 1 : 0;
  look_.reset();
}

void LookLog::ClosePass() {
  CloseLook();
  const Likelihoods pass = OfPass(*pass_);
  closed_.present += pass.present;
  closed_.absent += pass.absent;
  pass_.reset();
}

LookLog::Likelihoods LookLog::OfPass(const Evidence& pass) const {
  return {.present = LogSum(std::log1p(-params_.pass_failure) + pass.present,
                            std::log(params_.pass_failure) + pass.present_failing),
          .absent = LogSum(std::log1p(-params_.pass_clutter) + pass.absent,
                           std::log(params_.pass_clutter) + pass.absent_clutter)};
}

LookLog::Likelihoods LookLog::likelihoods() const {
  if (!look_) {
    return closed_;
  }
  Evidence pass = *pass_;
  pass += look_->mean();
  const Likelihoods under_way = OfPass(pass);
  return {.present = closed_.present + under_way.present,
          .absent = closed_.absent + under_way.absent};
}

PerVisibility LookLog::looks() const {
  return look_ ? PerVisibility(closed_looks_ + look_->counts()) : closed_looks_;
}

int LookLog::looks_with_box() const {
  return closed_looks_with_box_ + (look_ && look_->has_box ? 1 : 0);
}

}  // namespace limpet
