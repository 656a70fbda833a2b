// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/helm/answer_watch.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/helm/behavior_failure.hpp"
#include "limpet/helm/behavior_overrides.hpp"
#include "limpet/helm/behavior_status.hpp"
#include "limpet/helm/behavior_templates.hpp"
#include "limpet/helm/hosted_behavior.hpp"
#include "limpet/helm/life_event.hpp"
#include "limpet/helm/post_filter.hpp"
#include "limpet/helm/view_decision.hpp"
#include "limpet/helm/warning_book.hpp"
#include "limpet/mission/behavior_file.hpp"
#include "limpet/mission/mode_set.hpp"

namespace limpet {

/// What running behaviors did in an iteration, and who of them had a say.
struct IterationOutcome {
  std::span<const BehaviorTurn> turns;
  std::span<const std::string_view> active;
};

/// Builds the behaviors of .bhv files and keeps their lives: modes, conditions, flags, updates,
/// durations, templates and completion, as MOOS-IvP defines them. An iteration is `Update`, the
/// bids of those that run, `Settle`.
class BehaviorHost {
 public:
  /// Throws ConfigError with every problem of every behavior; an unknown parameter is one.
  /// With a `clock`, what behaviors do beside bidding is told if it takes long.
  explicit BehaviorHost(const std::vector<BehaviorFile>& files, RealClock clock = {});

  /// Variables whose mail the host wants: all that conditions, modes, updates and behaviors name.
  /// May grow while behaviors are spawned and updated.
  [[nodiscard]] std::vector<std::string> Variables() const;
  /// Variables that flags of its behaviors post.
  [[nodiscard]] std::vector<std::string> PostedVariables() const;
  /// `survey=SURVEY_UPDATES,...`: in which variable each behavior takes updates.
  [[nodiscard]] std::string UpdateVariables() const;
  /// What became of each update since the last call, as IVPHELM_UPDATE_RESULT has it.
  [[nodiscard]] std::vector<std::string> TakeUpdateResults() {
    return std::exchange(update_results_, {});
  }
  /// Lines of the behaviors' blocks that are known from existing missions, and have no effect or
  /// are taken as others; and those that are missing where MOOS-IvP's helm needs them.
  [[nodiscard]] std::vector<ConfigProblem> IgnoredLines() const;
  /// True if a behavior asks for view decisions when it runs.
  [[nodiscard]] bool WantsView() const;
  /// Which `initialize` lines are posted: all, or those alone that yield to what is known.
  enum class Initials { kAll, kDeferred };
  /// Posts of `initialize` lines, and what templates ask for.
  [[nodiscard]] std::vector<HelmPost> InitialPosts(Initials which = Initials::kAll) const;
  /// Takes mail: a value for the conditions, an update of behaviors, what they ask for.
  void SetVariable(const std::string& name, const Value& value, Seconds time = Seconds(0.0));
  /// What another one has heard is known here, too.
  void TakeHeard(const BehaviorHost& other) { heard_ = other.heard_; }
  /// What it has heard; for `VehicleState::heard`.
  [[nodiscard]] const HeardValues& heard() const { return heard_; }

  /// Evaluates modes, conditions and durations; starts what begins to run; returns what is to be
  /// posted.
  [[nodiscard]] std::vector<HelmPost> Update(const VehicleState& state);
  /// Carries out what behaviors did; lets go of those that have completed.
  [[nodiscard]] std::vector<HelmPost> Settle(const IterationOutcome& outcome,
                                             const VehicleState& state);
  /// What behaviors have thrown since the last call, where they do not bid.
  [[nodiscard]] std::vector<BehaviorFailure> TakeFailures() { return std::exchange(failures_, {}); }
  /// What of behaviors has taken long since the last call, where they do not bid.
  [[nodiscard]] std::vector<OwnedWarning> TakeLateCalls() { return std::exchange(late_calls_, {}); }
  /// Ends all that run, for good; returns what they post as they go, e.g. erase what they have
  /// drawn. REQUIRES: of the host nothing is asked after that but what has gone wrong.
  [[nodiscard]] std::vector<HelmPost> Retire(const VehicleState& state);
  /// Everything that behaviors post goes out once more, also what has not changed.
  void ForgetPosts() { filter_.Clear(); }

  /// Behaviors now running, in file order, but for those that could not be started.
  [[nodiscard]] const std::vector<WeightedBehavior>& running() const { return running_; }
  /// All behaviors, in file order and then in order of birth; those that completed in this
  /// iteration are still there.
  [[nodiscard]] const std::vector<BehaviorStatus>& statuses() const { return statuses_; }
  /// Who was made or has ended since the last call.
  [[nodiscard]] std::vector<LifeEvent> TakeLifeEvents() { return std::exchange(events_, {}); }
  /// `MODE@ACTIVE:SURVEYING`, several joined by `#`; "" without modes.
  [[nodiscard]] const std::string& modes() const { return mode_text_; }
  /// The tree of modes, as IVPHELM_MODESET has it.
  [[nodiscard]] std::string ModeTree() const { return modes_->Summary(); }
  /// Behaviors whose last update could not be applied, or whose block says what nobody heeds.
  [[nodiscard]] std::vector<OwnedWarning> warnings() const;

 private:
  [[nodiscard]] const Value* Find(std::string_view name) const;
  void AddBehavior(const ConfigBlock& block, std::vector<ConfigProblem>& problems);
  void Adopt(std::unique_ptr<HostedBehavior> hosted, std::string seed);
  void NoteRequest(const HostedBehavior& hosted);
  /// Warns of lines of its block that nobody heeds as they are.
  void NoteLines(const HostedBehavior& hosted);
  void Spawn(const std::string& variable, const std::string& text);
  void RemoveComplete();
  void RefreshStatuses();

  RealClock clock_;
  std::vector<InitialPost> initializes_;
  std::vector<HelmPost> requests_;  ///< of templates
  std::unique_ptr<ModeSet> modes_;
  std::optional<Seconds> began_;  ///< the first iteration
  HeardValues heard_;
  std::vector<std::unique_ptr<HostedBehavior>> hosted_;
  BehaviorTemplates templates_;
  PostFilter filter_;
  std::vector<WeightedBehavior> running_;
  std::string mode_text_;
  std::vector<BehaviorStatus> statuses_;
  std::vector<LifeEvent> events_;
  std::vector<std::string> update_results_;
  std::vector<BehaviorFailure> failures_;
  std::vector<OwnedWarning> late_calls_;
  std::vector<OwnedWarning> update_warnings_, block_warnings_;
};

}  // namespace limpet
