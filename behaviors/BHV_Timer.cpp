// SPDX-License-Identifier: MIT
#include "behaviors/BHV_Timer.hpp"

#include "limpet/helm/act_list.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/waypoints/map_params.hpp"

namespace limpet {

void BHV_Timer::Params::Describe(ParamCollector& visit) {
  DescribeVariable(visit, "var_status_idle", idle_variable, "Where the seconds of idleness go");
  DescribeVariable(visit, "var_status_running", running_variable,
                   "Where the seconds of running go");
  DescribeSuffix(visit, "status_suffix", suffix);
}

bool BHV_Timer::TakeOver(const Behavior& former, const std::vector<std::string>&) {
  times_ = dynamic_cast<const BHV_Timer&>(former).times_;
  return true;
}

std::vector<BehaviorAct> BHV_Timer::Spend(const VehicleState& state, bool is_running) {
  const Seconds elapsed = state.now - times_.last.value_or(state.now);
  times_.last = state.now;
  ActList acts;
  acts.Post(params_.idle_variable + params_.suffix, times_.idle.value());
  acts.Post(params_.running_variable + params_.suffix, times_.running.value());
  (is_running ? times_.running : times_.idle) += elapsed;
  return acts.Take();
}

MotionBid BHV_Timer::Move(const VehicleState& state) {
  MotionBid bid;
  bid.acts = Spend(state, true);
  return bid;
}

std::vector<BehaviorAct> BHV_Timer::Idle(const VehicleState& state) { return Spend(state, false); }

LIMPET_REGISTER_BEHAVIOR(BHV_Timer);

}  // namespace limpet
