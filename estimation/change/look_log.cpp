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
  object += other.object;
  failing += other.failing;
  bare += other.bare;
  faint_lookalike += other.faint_lookalike;
  return *this;
}

LookLog::Evidence LookLog::Evidence::operator/(double n) const {
  return {object / n, failing / n, bare / n, faint_lookalike / n};
}

LookLog::Evidence LookLog::Weigh(const FrameEvidence& frame) const {
  // A false alarm can fall on an object that the detector missed, so presence never has less chance
  // of a box than absence.
  const auto either = [&frame](const PerVisibility& detects) {
    return PerVisibility(1.0 - (1.0 - detects) * (1.0 - frame.false_alarm));
  };
  const PerVisibility clutter = params_.clutter_detects * frame.detects;
  return {.object = LogChance(either(frame.detects), frame.has_box),
          .failing = LogChance(either(params_.failing_detects * frame.detects), frame.has_box),
          .bare = LogChance(frame.false_alarm, frame.has_box),
          .faint_lookalike = LogChance(either(clutter), frame.has_box)};
}

void LookLog::Add(const FrameEvidence& frame) {
  LIMPET_REQUIRE(!look_ || frame.time >= last_time_, "frames out of order");
  if (look_ && frame.time - last_time_ > params_.new_pass_gap.value()) {
    ClosePass();
  } else if (look_ && params_.IsNewLook(frame.p_OC, look_->p_OC)) {
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
  closed_ += OfPass(*pass_);
  pass_.reset();
}

LookLog::Evidence LookLog::OfPass(const Evidence& pass) const {
  const auto may_fail = [&](const PerVisibility& seen) {
    return LogSum(std::log1p(-params_.pass_failure) + seen,
                  std::log(params_.pass_failure) + pass.failing);
  };
  return {.object = may_fail(pass.object),
          .failing = pass.failing,
          .bare = pass.bare,
          .faint_lookalike = may_fail(pass.faint_lookalike)};
}

LookLog::Likelihoods LookLog::likelihoods() const {
  Evidence all = closed_;
  if (look_) {
    Evidence pass = *pass_;
    pass += look_->mean();
    all += OfPass(pass);
  }
  // Every other lookalike shows as reliably as an object: being seen often does not unmask it.
  return {.present = LogSum(std::log1p(-params_.place_failure) + all.object,
                            std::log(params_.place_failure) + all.failing),
          .bare = all.bare,
          .lookalike = std::log(0.5) + LogSum(all.object, all.faint_lookalike)};
}

PlaceEvidence LookLog::evidence() const {
  const Likelihoods seen = likelihoods();
  return {.present = seen.present - seen.bare, .lookalike = seen.lookalike - seen.bare};
}

PerVisibility LookLog::looks() const {
  return look_ ? PerVisibility(closed_looks_ + look_->counts()) : closed_looks_;
}

int LookLog::looks_with_box() const {
  return closed_looks_with_box_ + (look_ && look_->has_box ? 1 : 0);
}

}  // namespace limpet
