// SPDX-License-Identifier: MIT
#include "limpet/launch/launch_faults.hpp"

#include <algorithm>
#include <cstdint>

#include "limpet/core/byte_units.hpp"
#include "limpet/mission/fault_names.hpp"
#include "limpet/mission/host_faults_of.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {
namespace {

constexpr const char* kHelm = "pHelm";

std::vector<ScenarioFault> FaultsIn(const LaunchPlan& plan) {
  std::vector<std::string> apps;
  bool is_simulated = false;
  for (const LaunchItem& item : plan.items) {
    apps.push_back(item.name);
    is_simulated = is_simulated || item.program.filename() == "uSimVehicle";
  }
  if (!is_simulated) return {};
  return HostFaultsOf(plan.mission, plan.mission_file.parent_path(), apps);
}

}  // namespace

LaunchFaults::LaunchFaults(const LaunchPlan& plan)
    : schedule_(FaultsIn(plan)), is_active_(schedule_.faults().size(), false) {
  if (!are_none()) host_.emplace();
}

void LaunchFaults::Prepare(Supervisor& supervisor) const {
  if (host_) supervisor.Share(HostFaults::kVariable, host_->descriptor());
}

void LaunchFaults::Listen(CommunityWatch& watch) const {
  for (const std::string& variable : schedule_.Variables()) {
    watch.Listen(variable);
  }
  if (schedule_.Has(fault_names::kSlowPlanner)) watch.Listen(topics::kHelmBids.name);
}

void LaunchFaults::Hear(const CommunityWatch& watch) {
  for (const std::string& variable : schedule_.Variables()) {
    const auto heard = watch.Latest(variable);
    int& times = heard_times_[variable];
    if (!heard || heard->times == times) continue;
    times = heard->times;
    schedule_.Hear(variable, heard->is_number ? Value(heard->number) : Value(heard->text));
  }
}

void LaunchFaults::Apply(CommunityWatch& watch, Supervisor& supervisor, Seconds now) {
  if (are_none()) return;
  Hear(watch);
  schedule_.Update(now);
  if (schedule_.Has(fault_names::kSlowPlanner)) SlowPlanner(watch, supervisor, now);
  for (std::size_t i = 0; i < is_active_.size(); ++i) {
    if (schedule_.IsActive(i) == is_active_[i]) continue;
    is_active_[i] = schedule_.IsActive(i);
    Switch(i, supervisor);
  }
}

void LaunchFaults::Switch(std::size_t index, Supervisor& supervisor) {
  const ScenarioFault& fault = schedule_.faults()[index];
  const bool is_active = is_active_[index];
  if (fault.what == fault_names::kAppDown) {
    supervisor.KeepDown(fault.app, is_active);
  } else if (fault.what == fault_names::kAppHangs) {
    supervisor.Halt(fault.app, is_active);
  } else if (fault.what == fault_names::kDiskLow) {
    host_->LimitDisk(is_active
                         ? std::optional(static_cast<std::uint64_t>(fault.size * kBytesPerMib))
                         : std::nullopt);
  } else if (fault.what == fault_names::kClockStepped) {
    host_->SetWallAhead(Seconds(is_active ? fault.size : 0.0));
  } else {
    host_->FailDisk(DiskFaultOf(schedule_));
  }
}

void LaunchFaults::SlowPlanner(CommunityWatch& watch, Supervisor& supervisor, Seconds now) {
  const auto decided = watch.Latest(topics::kHelmBids.name);
  int& times = heard_times_[topics::kHelmBids.name];
  const bool has_decided = decided && decided->times != times;
  if (decided) times = decided->times;
  const ScenarioFault* slow = schedule_.Active(fault_names::kSlowPlanner);
  if (slow != nullptr && has_decided && !plans_until_) {
    plan_s_ = slow->size;
    plans_until_ = now + Seconds(plan_s_);
    supervisor.Halt(kHelm, true);
  } else if (plans_until_ && now >= *plans_until_) {
    plans_until_.reset();
    supervisor.Halt(kHelm, false);
    watch.client().Publish(topics::kPlanTime.name, plan_s_);
  }
}

std::optional<double> LaunchFaults::memory_mib() const {
  const ScenarioFault* fault = schedule_.Active(fault_names::kMemory);
  return fault != nullptr ? std::optional(fault->size) : std::nullopt;
}

std::optional<ProcessorLoad> LaunchFaults::processor() const {
  const ScenarioFault* fault = schedule_.Active(fault_names::kProcessor);
  if (fault == nullptr) return std::nullopt;
  return ProcessorLoad{.percent = fault->size, .app = "fault"};
}

}  // namespace limpet
