// SPDX-License-Identifier: MIT
#include "behaviors/BHV_SurfaceFix.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "limpet/helm/act_list.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/planning/fence_allowance.hpp"
#include "limpet/topics/surface_fix.hpp"

namespace limpet {
namespace {

constexpr const char* kFixSource = "surface_fix";
constexpr std::size_t kMostOptions = 6;  // that it offers once more, after a fix

}  // namespace

bool BHV_SurfaceFix::HasStayedEnough(const VehicleState& state) {
  if (state.nav.down < params_.surface_depth.value() && !at_surface_) at_surface_ = state.now;
  if (!at_surface_) return false;
  const Seconds stay = state.now - *at_surface_;
  const bool is_sure =
      state.nav.gps.is_valid.value_or(false) && sigma_ <= params_.fix_sigma.value();
  return stay >= params_.longest_stay || (stay >= params_.shortest_stay && is_sure);
}

MotionBid BHV_SurfaceFix::Move(const VehicleState& state) {
  sigma_ = std::max(state.nav.sd_north, state.nav.sd_east);
  depth_ = state.nav.down;
  if (area_ != state.area) {
    area_ = state.area;
    region_.reset();
    if (area_) region_.emplace(*area_);
  }
  ActList acts;
  if (!is_up_ && state.guidance && state.guidance->purpose == kFixSource) {
    is_up_ = true;
    at_surface_.reset();
    acts.Post(topics::kSurfaceFix.name, std::string("true"));
  } else if (is_up_ && HasStayedEnough(state)) {
    is_up_ = false;
    not_before_ = state.now + params_.pause;
    acts.Post(topics::kSurfaceFix.name, std::string("false"));
  }
  MotionBid bid;
  bid.acts = acts.Take();
  return bid;
}

std::vector<BehaviorAct> BHV_SurfaceFix::Stop(const VehicleState& state) {
  static_cast<void>(state);
  ActList acts;
  if (is_up_) acts.Post(topics::kSurfaceFix.name, std::string("false"));
  is_up_ = false;
  return acts.Take();
}

bool BHV_SurfaceFix::IsFixWorthwhile() const {
  constexpr double kTimes = 1.5;  // as sure: for less it neither charges nor offers
  return sigma_ > kTimes * params_.fix_sigma.value();
}

double BHV_SurfaceFix::Cost() const {
  const Seconds time = 2.0 * Seconds(depth_ / params_.ascent_speed.value()) +
                       0.5 * (params_.shortest_stay + params_.longest_stay);
  return time.value() * params_.speed.value();
}

double BHV_SurfaceFix::DoubtSaved(const DubinsPath& path) const {
  constexpr double kStep = 2.0;  // [m]
  const double now = FenceAllowance::kSigmas * sigma_,
               with_fix = FenceAllowance::kSigmas * params_.fix_sigma.value();
  double saved = 0.0;
  path.Sample(kStep, [&](const Pose2& at, double) {
    const double clearance = std::max(0.0, region_->Clearance({at.north, at.east}));
    saved += kStep * (std::max(0.0, now - clearance) - std::max(0.0, with_fix - clearance));
  });
  return saved;
}

void BHV_SurfaceFix::Offer(const Situation& now, std::vector<Option>& options) const {
  const bool is_pausing = not_before_ && now.now < *not_before_;
  if (!region_ || is_pausing || !IsFixWorthwhile()) return;
  const std::size_t others = std::min(options.size(), kMostOptions);
  for (std::size_t i = 0; i < others; ++i) {
    Option after_fix = options[i];
    after_fix.source = kFixSource;
    options.push_back(std::move(after_fix));
  }
}

std::optional<Bid> BHV_SurfaceFix::Value(const Prospect& prospect, const Situation& now) const {
  static_cast<void>(now);
  if (!region_ || !IsFixWorthwhile()) return std::nullopt;
  if (prospect.option->source == kFixSource) {
    // An option that ends where the survey does pays for the fix at once.
    const double share =
        prospect.option->is_whole() ? 1.0 : prospect.length() / params_.pays_over.value();
    return Bid{.value = -share * Cost(), .why = {{"fix", share * Cost()}}, .veto = {}};
  }
  const double doubt = params_.doubt_weight * DoubtSaved(prospect.whole());
  return Bid{.value = -doubt, .why = {{"in_doubt", doubt}}, .veto = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_SurfaceFix);

}  // namespace limpet
