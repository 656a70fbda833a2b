// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/helm/behavior_host.hpp"

namespace limpet {

/// One iteration of the helm as others see it.
struct HelmIteration {
  std::int64_t number = 0;
  Seconds now;
  std::optional<double> course_deg, speed, depth;  ///< as decided; absent: nobody had an opinion
  bool is_halted = false;
  int functions = 0;  ///< opinions that went into the decision
  int warnings = 0;
  std::string modes;
  std::vector<BehaviorStatus> behaviors;
  std::vector<std::string> active;  ///< those of them that bid
};

/// What uHelmScope, viewers and pNodeReporter read of the helm: IVPHELM_* in MOOS-IvP's forms.
/// Times of computation are left out: they would make two runs of one mission differ.
class HelmJournal {
 public:
  using Post = std::function<void(std::string variable, Value value)>;
  enum class State { kActive, kRunning, kIdle };

  HelmJournal(const std::vector<std::string>& domain, Post post);

  /// Once, before the first iteration.
  void PostStart(const BehaviorHost& host, Seconds now);
  void PostIteration(const HelmIteration& iteration);
  /// The next summary is a whole one.
  void Rejournal() { summary_.clear(); }

  struct Entry {
    State state = State::kIdle;
    Seconds since;
  };
  /// What each behavior does, and since when.
  [[nodiscard]] const std::map<std::string, Entry>& entries() const { return entries_; }
  [[nodiscard]] static const char* NameOf(State state);

 private:
  void UpdateEntries(const HelmIteration& iteration);
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> Fields(
      const HelmIteration& iteration) const;
  [[nodiscard]] std::string Described(const HelmIteration& iteration, State state) const;
  [[nodiscard]] std::string Named(const HelmIteration& iteration, State state) const;
  void PostIfChanged(const std::string& variable, const std::string& text);

  std::string domain_;  ///< `course,0,359,360:speed,0,1,21`
  Post post_;
  std::map<std::string, Entry> entries_;          ///< by behavior
  std::map<std::string, std::string> summary_;    ///< fields as last posted
  std::map<std::string, std::string> variables_;  ///< texts as last posted
};

}  // namespace limpet
