// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/helm/view_decision.hpp"
#include "limpet/helm/warning_book.hpp"
#include "limpet/mission/behavior_file.hpp"
#include "limpet/mission/flag.hpp"
#include "limpet/mission/mode_set.hpp"

namespace limpet {

/// A variable that the helm is to write: a flag, a mode, an initial value.
struct HelmPost {
  std::string variable;
  Value value;
  std::string aux;  ///< which behavior or rule
};

/// What one behavior is doing, for whoever watches the helm.
struct BehaviorStatus {
  std::string name, type;
  double weight = 0.0;
  bool is_running = false;
  int good_updates = 0, updates = 0;  ///< parts of `updates` mail: applied, and all
  bool operator==(const BehaviorStatus&) const = default;
};

/// `name.key=value` becomes an entry of the behavior called name. Throws ConfigError if no behavior
/// has that name.
void ApplyBehaviorSettings(std::vector<BehaviorFile>& files,
                           const std::vector<std::string>& settings);

/// Builds the behaviors of .bhv files and keeps their run states: modes, conditions, flags and
/// updates, as MOOS-IvP defines them.
class BehaviorHost {
 public:
  /// Throws ConfigError with every problem of every behavior; an unknown parameter is one.
  explicit BehaviorHost(const std::vector<BehaviorFile>& files);
  ~BehaviorHost();
  BehaviorHost(const BehaviorHost&) = delete;
  BehaviorHost& operator=(const BehaviorHost&) = delete;

  /// Variables whose mail the host wants: all that conditions, modes and updates name.
  [[nodiscard]] std::vector<std::string> Variables() const;
  /// Posts of `initialize` lines.
  [[nodiscard]] std::vector<HelmPost> InitialPosts() const;
  /// Takes mail: a value for the conditions, or an update of behaviors.
  void SetVariable(const std::string& name, const Value& value);

  /// Evaluates modes and conditions; starts what begins to run; returns flags and changed modes.
  [[nodiscard]] std::vector<HelmPost> Update(const VehicleState& state);
  /// Behaviors now running, in file order.
  [[nodiscard]] const std::vector<WeightedBehavior>& running() const { return running_; }
  /// All behaviors, in file order.
  [[nodiscard]] const std::vector<BehaviorStatus>& statuses() const { return statuses_; }
  /// `MODE@ACTIVE:SURVEYING`, several joined by `#`; "" without modes.
  [[nodiscard]] const std::string& modes() const { return mode_text_; }
  /// As IVPHELM_MODESET has it.
  [[nodiscard]] std::string ModeTree() const { return modes_->Summary(); }
  /// Behaviors whose last update could not be applied.
  [[nodiscard]] const std::vector<OwnedWarning>& warnings() const { return warnings_; }

 private:
  struct Hosted;
  [[nodiscard]] const Value* Find(std::string_view name) const;
  void AddBehavior(ConfigBlock block, std::vector<ConfigProblem>& problems);
  void UpdateRunState(Hosted& hosted, const VehicleState& state, std::vector<HelmPost>& posts);
  void PostFlags(const Hosted& hosted, const std::vector<Flag>& flags, const VehicleState& state,
                 std::vector<HelmPost>& posts);
  void ApplyUpdate(Hosted& hosted, const std::string& text);

  std::vector<InitialPost> initializes_;
  std::unique_ptr<ModeSet> modes_;
  std::map<std::string, Value, std::less<>> variables_;
  std::vector<std::unique_ptr<Hosted>> hosted_;
  std::vector<WeightedBehavior> running_;
  std::string mode_text_;
  std::vector<BehaviorStatus> statuses_;  ///< parallel to hosted_
  std::vector<OwnedWarning> warnings_;
};

}  // namespace limpet
