// SPDX-License-Identifier: MIT
#include "behaviors/BHV_GoToDepth.hpp"

#include <cmath>

#include "limpet/core/number_text.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/waypoints/map_params.hpp"

namespace limpet {
namespace {

/// `40,60 : 30,45 : 20`: depths with the seconds to stay there.
std::optional<std::vector<BHV_GoToDepth::Level>> ParseLevels(std::string_view text) {
  std::vector<BHV_GoToDepth::Level> levels;
  for (const std::string& part : Split(text, ':')) {
    const std::vector<std::string> pair = Split(part, ',');
    const auto depth = ParseNumber(Trim(pair[0]));
    const auto stay = pair.size() > 1 ? ParseNumber(Trim(pair[1])) : std::optional(0.0);
    if (pair.size() > 2 || !depth || !stay || *depth < 0.0 || *stay < 0.0) return std::nullopt;
    levels.push_back({.depth = *depth, .stay = Seconds(*stay)});
  }
  return levels;
}

}  // namespace

void BHV_GoToDepth::Params::Describe(ParamCollector& visit) {
  visit.Parsed("depth", "depth or depth,seconds, several joined by `:`",
               "Depths [m], and how long to stay at each", "", [this](std::string_view text) {
                 const auto read = ParseLevels(text);
                 if (read) levels = *read;
                 return text.empty() || read.has_value();
               });
  visit("capture_delta", capture_delta, "This near it has arrived",
        InRange(Meters(0.0), Meters(1000.0)));
  visit.Also({"arrival_delta"});
  visit("repeat", repeats, "How often again", InRange(0, 1000000));
  TakeWholePart(visit);
  visit("arrival_flag", arrival_flag, "The number of arrivals goes to GTD_ and this");
  visit.Also({"capture_flag"});
}

bool BHV_GoToDepth::HasArrived(double depth) {
  const double target = params_.levels[index_].depth;
  const double before = last_depth_.value_or(depth);
  last_depth_ = depth;
  const bool has_crossed = (before - target) * (depth - target) < 0.0;
  return has_crossed || std::abs(depth - target) <= params_.capture_delta.value();
}

bool BHV_GoToDepth::GoOn() {
  arrived_.reset();
  if (++index_ < params_.levels.size()) return true;
  index_ = 0;
  if (repeats_left_ > 0) {
    --repeats_left_;
    return true;
  }
  repeats_left_ = params_.repeats;
  arrivals_ = 0;
  last_depth_.reset();
  return false;
}

MotionBid BHV_GoToDepth::Move(const VehicleState& state) {
  MotionBid bid;
  if (params_.levels.empty()) return bid;
  ActList acts;
  const bool is_over = arrived_ && state.now - *arrived_ >= params_.levels[index_].stay;
  const bool goes_on = !is_over || GoOn();
  if (goes_on) {
    const double target = params_.levels[index_].depth;
    if (is_over) acts.Post("LEVEL_DEPTH", target);
    if (!arrived_ && HasArrived(state.nav.down)) {
      arrived_ = state.now;
      ++arrivals_;
      acts.Post(params_.arrival_flag.empty() ? "" : "GTD_" + params_.arrival_flag,
                static_cast<double>(arrivals_));
    }
    constexpr double kSkirt = 5.0;  // [m]
    bid.depth = Peak{.summit = target, .flat_half_width = 0.0, .base_half_width = kSkirt};
  } else {
    acts.Complete();
  }
  bid.acts = acts.Take();
  return bid;
}

LIMPET_REGISTER_BEHAVIOR(BHV_GoToDepth);

}  // namespace limpet
