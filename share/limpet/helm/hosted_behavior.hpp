// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/helm/answer_watch.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/helm/behavior_failure.hpp"
#include "limpet/helm/behavior_status.hpp"
#include "limpet/helm/behavior_update.hpp"
#include "limpet/helm/common_settings.hpp"
#include "limpet/helm/flag_macros.hpp"
#include "limpet/helm/post_filter.hpp"
#include "limpet/helm/warning_book.hpp"

namespace limpet {

/// One iteration as hosted behaviors see it: what they know, and where their posts go.
struct HelmTurn {
  const VehicleState& state;
  const ValueLookup& lookup;
  PostFilter& filter;
  std::vector<HelmPost>& posts;
};

/// A behavior with its life: when it runs, what it posts then, what mail changes of it, when it
/// ends.
class HostedBehavior {
 public:
  /// Throws ConfigError with every problem of the block.
  /// With a `clock`, what takes long is told, and an idle behavior that does rests.
  explicit HostedBehavior(ConfigBlock block, RealClock clock = {});

  [[nodiscard]] const std::string& name() const { return settings_.name; }
  [[nodiscard]] const std::string& type() const { return block_.name; }
  [[nodiscard]] const CommonSettings& settings() const { return settings_; }
  [[nodiscard]] Behavior& behavior() const { return *behavior_; }
  [[nodiscard]] bool is_running() const { return state_ == State::kRunning; }
  /// It runs and could be started: its bids are to be heard.
  [[nodiscard]] bool may_bid() const { return is_running() && !needs_start_; }
  /// False also if it throws when asked.
  [[nodiscard]] bool WantsView() const;
  [[nodiscard]] bool is_complete() const { return state_ == State::kComplete; }
  /// Why it has completed, if it said so.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] BehaviorStatus Status() const;
  /// Every variable whose mail it wants.
  [[nodiscard]] std::vector<std::string> Variables() const;
  /// Keys of its block that nothing heeds.
  [[nodiscard]] std::vector<ConfigProblem> IgnoredLines() const;
  /// That it has no limit in time, where MOOS-IvP's helm would end it at once.
  [[nodiscard]] std::optional<ConfigProblem> DurationNote() const;
  /// Values of its block that are not allowed and were taken as others.
  [[nodiscard]] std::vector<ConfigProblem> AlteredLines() const;

  /// It was made by an update, while the helm ran.
  void MarkSpawned(std::string base_name) { spawn_base_ = std::move(base_name); }
  /// Mail of a variable, e.g. one that winds its duration up.
  void Hear(const std::string& variable, const Value& value);
  /// An update for it, unless that names another one. Parts that cannot be applied are left out,
  /// and complained about.
  [[nodiscard]] UpdateOutcome ApplyUpdate(const std::string& text);

  /// Before the bids: conditions, duration and starvation decide whether it runs.
  void Begin(HelmTurn& turn);
  /// After them: what it did, and whether it had a say.
  void Settle(std::span<const BehaviorAct> acts, bool is_active, HelmTurn& turn);
  /// It ceases to run, if it does, and is not asked again.
  void Retire(HelmTurn& turn) {
    if (is_running()) End(turn);
  }
  /// What of it has taken long since the last call, where it does not bid.
  [[nodiscard]] std::vector<OwnedWarning> TakeLateCalls() { return std::exchange(late_calls_, {}); }
  /// What it has thrown since the last call, where it does not bid.
  [[nodiscard]] std::vector<BehaviorFailure> TakeFailures() { return std::exchange(failures_, {}); }

 private:
  enum class State { kNew, kIdle, kRunning, kComplete };

  /// The behavior of a block; throws ConfigError, and nothing else.
  [[nodiscard]] static std::unique_ptr<Behavior> Make(const ConfigBlock& block);
  /// Runs `work`, which calls the behavior; false if that has thrown, which is noted, like a call
  /// that takes long.
  template <class Work>
  bool Call(const Work& work) {
    bool is_good = false;
    NoteLate(watch_.Time([&] { is_good = Heard(name(), failures_, work); }));
    return is_good;
  }
  void NoteLate(const std::optional<std::string>& complaint);
  void PerformIdle(HelmTurn& turn);
  [[nodiscard]] bool IsMeant(const BehaviorUpdate& update) const;
  /// The complaint if the part is not allowed; else `block` has it.
  [[nodiscard]] std::optional<std::string> TryPart(const ConfigEntry& part,
                                                   ConfigBlock& block) const;
  void Rebuild(const ConfigBlock& block, const BehaviorUpdate& update);
  /// The first condition that does not hold; "" if all do.
  [[nodiscard]] std::string UnmetCondition(const HelmTurn& turn);
  /// Input of `nostarve` that is too old, or that nobody has written; "" if there is none.
  [[nodiscard]] std::string MissingInput(const HelmTurn& turn) const;
  /// True if its time is up, which ends a behavior that is not perpetual.
  [[nodiscard]] bool IsOver(HelmTurn& turn);
  void BeginIdle(HelmTurn& turn);
  void BeginRunning(HelmTurn& turn);
  void Complete(const std::string& reason, HelmTurn& turn);
  void End(HelmTurn& turn);
  void Perform(std::span<const BehaviorAct> acts, HelmTurn& turn);
  /// Once it is made, and when an update has changed it.
  void TellSettings(HelmTurn& turn);
  void PostFlags(std::span<const Flag> flags, HelmTurn& turn);
  void PostFlag(const Flag& flag, HelmTurn& turn);
  void Post(const BehaviorPost& post, HelmTurn& turn) const;
  void PostTimeLeft(HelmTurn& turn);

  ConfigBlock block_;
  CommonSettings settings_;
  std::unique_ptr<Behavior> behavior_;
  std::vector<std::string> own_variables_;  ///< that the behavior reads
  std::vector<BehaviorFailure> failures_;
  std::vector<OwnedWarning> late_calls_;
  AnswerWatch watch_;  ///< over what it does while idle
  DurationClock clock_;
  FlagMacros macros_;
  State state_ = State::kNew;
  bool begins_to_run_ = false;  ///< in this iteration
  bool needs_start_ = false;    ///< an update has made it anew, or its start has failed
  bool is_active_ = false;      ///< had a say in the last iteration
  bool are_spawn_flags_due_ = true, are_config_flags_due_ = true, are_spawnx_flags_due_ = true;
  std::optional<std::string> spawn_base_;
  std::string last_update_, complaint_, reason_, held_back_by_;
  int good_updates_ = 0, bad_updates_ = 0;
};

}  // namespace limpet
