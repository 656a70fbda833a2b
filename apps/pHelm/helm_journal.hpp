// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/helm/behavior_host.hpp"
#include "limpet/helm/life_event.hpp"

namespace limpet {

/// One iteration of the helm as others see it.
struct HelmIteration {
  std::int64_t number = 0;
  Seconds now;
  std::optional<double> course_deg, speed, depth;  ///< as decided; absent: nobody had an opinion
  bool is_halted = false;
  int functions = 0;  ///< opinions that went into the decision
  int warnings = 0;
  std::string_view modes;
  std::span<const BehaviorStatus> behaviors;  ///< all of them, those that have just completed too
  std::vector<std::string_view> active;       ///< names of those that bid
};

/// What uHelmScope, viewers and pNodeReporter read of the helm: IVPHELM_* in MOOS-IvP's forms.
/// Times of computation are left out: they would make two runs of one mission differ.
class HelmJournal {
 public:
  using Post = std::function<void(std::string variable, Value value)>;
  enum class State { kActive, kRunning, kIdle, kComplete };

  HelmJournal(const std::vector<std::string>& domain, Post post);

  /// Before the first iteration, and of behaviors that all are new.
  void PostStart(const BehaviorHost& host, Seconds now);
  void PostIteration(const HelmIteration& iteration);
  /// Who was made or has ended in an iteration.
  void PostLifeEvents(std::span<const LifeEvent> events, std::int64_t iteration, Seconds now);
  /// What became of updates.
  void PostUpdateResults(std::span<const std::string> results);
  /// What behaviors hear and post, and where they take updates, if that is new.
  void PostVariables(const BehaviorHost& host);
  /// Posts the number of functions in BHV_IPF, if it is new.
  void PostPieces(int pieces);
  /// The next summary is a whole one.
  void Rejournal() { summary_.clear(); }

  struct Entry {
    BehaviorStatus behavior;
    State state = State::kIdle;
    Seconds since;
    bool operator==(const Entry&) const = default;
  };
  /// What each behavior does, and since when; in file order.
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  [[nodiscard]] static const char* NameOf(State state);

 private:
  /// How many behaviors have completed in this iteration, if that is another number.
  void TellCompleted(int count);
  void PostUpdateVariables(const std::string& variables);
  /// True if something about a behavior is new.
  [[nodiscard]] bool UpdateEntries(const HelmIteration& iteration);
  [[nodiscard]] std::string Described(State state) const;
  [[nodiscard]] std::string Named(State state) const;
  /// BHV_STATUS of those of whom it says something new.
  void PostStatuses();
  /// Adds a field to a summary if its text is new.
  void AddField(const std::string& name, const std::string& text, std::string& summary);
  /// The names of those in that state, and how many, if they are others than last time.
  void PostNames(const std::string& variable, const std::string& count, State state);

  std::string domain_;  ///< `course,0,359,360:speed,0,1,21`
  bool has_depth_;      ///< it decides on the depth, too
  Post post_;
  std::vector<Entry> entries_;
  Seconds started_{0.0};
  std::optional<std::string> state_variables_;  ///< as last posted
  std::optional<int> completed_;  ///< behaviors that ended in an iteration, as last posted
  int alive_ = 0;
  int made_ = 0;                                 ///< behaviors, ever
  std::optional<int> functions_;                 ///< as last posted
  int pieces_ = 0;                               ///< as last posted
  std::string update_variables_;                 ///< as last posted
  std::map<std::string, std::string> summary_;   ///< fields as last posted
  std::map<State, std::string> names_;           ///< as last posted
  std::map<std::string, std::string> statuses_;  ///< of each behavior, as last posted
};

}  // namespace limpet
