// SPDX-License-Identifier: MIT
#include "limpet/runs/session_faults.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "limpet/app/host_faults.hpp"
#include "limpet/core/byte_units.hpp"
#include "limpet/mission/fault_names.hpp"
#include "limpet/mission/host_faults_of.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/safety.hpp"
#include "limpet/topics/wall_clock.hpp"

namespace limpet {
namespace {

constexpr const char* kHelm = "pHelm";

}  // namespace

SessionFaults::SessionFaults(const MissionFile& mission, const std::filesystem::path& folder)
    : schedule_(HostFaultsOf(mission, folder, EmbeddedApps(mission))),
      is_active_(schedule_.faults().size(), false) {}

void SessionFaults::Hear(const Message& message) {
  schedule_.Hear(message.name, message.value);
  if (message.name == topics::kHelmBids.name) decided_ = message.time;
}

void SessionFaults::SlowPlanner(EmbeddedCommunity& community) {
  const ScenarioFault* slow = schedule_.Active(fault_names::kSlowPlanner);
  const bool has_decided = std::exchange(decided_, std::nullopt).has_value();
  if (slow != nullptr && has_decided && !plans_until_) {
    plan_s_ = slow->size;
    plans_until_ = community.now() + Seconds(plan_s_);
    community.Stall(kHelm);
  } else if (plans_until_ && community.now() >= *plans_until_) {
    plans_until_.reset();
    community.Stall(kHelm, false);
    community.Poke(topics::kPlanTime.name, plan_s_);
  }
}

void SessionFaults::Apply(EmbeddedCommunity& community) {
  schedule_.Update(community.now());
  if (schedule_.Has(fault_names::kSlowPlanner)) SlowPlanner(community);
  if (schedule_.Has(fault_names::kClockStepped) && !std::exchange(is_clock_told_, true))
    TellClock(community);
  for (std::size_t i = 0; i < is_active_.size(); ++i) {
    if (schedule_.IsActive(i) == is_active_[i]) {
      continue;
    }
    is_active_[i] = schedule_.IsActive(i);
    Switch(i, community);
  }
}

void SessionFaults::Switch(std::size_t index, EmbeddedCommunity& community) {
  const ScenarioFault& fault = schedule_.faults()[index];
  if (!fault.app.empty()) {
    community.Stall(fault.app, is_active_[index]);
    if (fault.what == fault_names::kAppDown) TellApps(community);
  } else if (fault.what == fault_names::kMemory) {
    community.Poke(topics::kLaunchMemory.name, is_active_[index] ? fault.size : 0.0);
  } else if (fault.what == fault_names::kProcessor) {
    const ProcessorLoad load{.percent = is_active_[index] ? fault.size : 0.0, .app = "fault"};
    community.Poke(topics::kLaunchProcessor.name, TopicCodec<ProcessorLoad>::Encode(load));
  } else if (fault.what == fault_names::kDiskLow) {
    community.LimitDisk(is_active_[index]
                            ? std::optional(static_cast<std::uint64_t>(fault.size * kBytesPerMib))
                            : std::nullopt);
  } else if (fault.what == fault_names::kClockStepped) {
    ++clock_steps_;
    TellClock(community);
  } else if (fault.what != fault_names::kSlowPlanner) {
    community.FailDisk(DiskFaultOf(schedule_));
  }
}

void SessionFaults::TellApps(EmbeddedCommunity& community) const {
  std::string status;
  for (std::size_t i = 0; i < is_active_.size(); ++i) {
    const ScenarioFault& fault = schedule_.faults()[i];
    if (fault.what != fault_names::kAppDown) continue;
    status += fmt::format("{}app={},state={},restarts=0", status.empty() ? "" : " # ", fault.app,
                          is_active_[i] ? "given_up" : "running");
  }
  community.Poke(topics::kLaunchStatus.name, TopicCodec<std::string>::Encode(status));
}

void SessionFaults::TellClock(EmbeddedCommunity& community) const {
  const ScenarioFault* step = schedule_.Active(fault_names::kClockStepped);
  const double ahead = step != nullptr ? step->size : 0.0;
  const double vehicle = community.now().value();
  community.Poke(
      topics::kWallClock.name,
      TopicCodec<WallClock>::Encode(
          {.vehicle = vehicle, .wall = vehicle + ahead, .ahead = ahead, .steps = clock_steps_}));
}

}  // namespace limpet
