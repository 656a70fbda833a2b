// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/helm/view_decision.hpp"
#include "limpet/mission/behavior_file.hpp"

namespace limpet {

/// A variable that the helm is to write: a flag, a mode, an initial value.
struct HelmPost {
  std::string variable;
  Value value;
  std::string aux;  ///< which behavior or rule
};

/// Builds the behaviors of .bhv files and keeps their run states: modes, conditions, flags and updates, as MOOS-IvP
/// defines them (idle, running, active).
class BehaviorHost {
 public:
  /// Throws ConfigError with every problem of every behavior; an unknown parameter is one.
  /// `settings` are overrides `name.key=value`.
  BehaviorHost(const std::vector<BehaviorFile>& files, const std::vector<std::string>& settings);
  ~BehaviorHost();

  /// Variables whose mail the host wants: all that conditions, modes and updates name.
  [[nodiscard]] std::vector<std::string> Variables() const;
  /// Posts of `initialize` lines.
  [[nodiscard]] std::vector<HelmPost> InitialPosts() const;
  /// Takes mail: the value table, and updates of behaviors.
  void SetVariable(const std::string& name, const Value& value);

  /// Evaluates modes and conditions; starts what begins to run; returns flags and changed modes to post.
  [[nodiscard]] std::vector<HelmPost> Update(const VehicleState& state);
  /// Behaviors now running, in file order.
  [[nodiscard]] const std::vector<WeightedBehavior>& running() const { return running_; }
  [[nodiscard]] std::vector<std::string> IdleNames() const;
  /// What the last updates said that could not be applied, oldest first; cleared by the call.
  [[nodiscard]] std::vector<BehaviorWarning> TakeWarnings();

 private:
  struct Hosted;
  const Value* Find(std::string_view name) const;
  void AddBehavior(const ConfigBlock& block, std::vector<ConfigProblem>& problems);
  void ApplyUpdate(Hosted& hosted, const std::string& text);

  std::vector<BehaviorFile> files_;
  std::unordered_map<std::string, Value> variables_;
  std::vector<std::unique_ptr<Hosted>> hosted_;
  std::vector<WeightedBehavior> running_;
  std::vector<BehaviorWarning> warnings_;
};

}  // namespace limpet
