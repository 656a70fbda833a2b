// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "limpet/mission/behavior_file.hpp"
#include "limpet/mission/condition.hpp"

namespace limpet {

/// Evaluates the mode declarations of a behavior file, once per helm iteration and before the
/// behaviors. Top to bottom: if all conditions of a declaration hold, its variable takes its value;
/// otherwise, if the condition on the variable itself holds (or there is none), the else-value;
/// otherwise the declaration says nothing. The first condition on the variable itself names the
/// parent: `MODE = ACTIVE` and value SURVEYING make `ACTIVE:SURVEYING`. Later declarations see, and
/// may override, the results of earlier ones; a variable that nothing sets keeps its last value.
class ModeSet {
 public:
  struct Mode {
    std::string variable;
    std::string value;
    bool is_changed = false;  ///< since the last evaluation: to be posted
  };

  explicit ModeSet(std::vector<ModeDeclaration> declarations);

  /// Every mode variable with a value, sorted by name. `lookup` need not know the modes.
  std::vector<Mode> Evaluate(const ValueLookup& lookup, Seconds utc_now);
  /// The value of a mode variable, or nullptr if it is none or has no value yet.
  [[nodiscard]] const Value* Find(std::string_view variable) const;
  /// Variables that the conditions read, sorted.
  [[nodiscard]] std::vector<std::string> Variables() const;
  /// IVPHELM_MODESET: per variable its name, then parent,child pairs (`---`: no parent), joined by
  /// `#`: `MODE#---,ACTIVE#---,INACTIVE#ACTIVE,SURVEYING#ACTIVE,LOITERING`.
  [[nodiscard]] std::string Summary() const;

 private:
  struct Entry {
    ModeDeclaration declaration;
    std::string parent;         ///< value of the first condition on the variable itself
    std::size_t own_condition;  ///< its index, or npos
  };
  std::vector<Entry> entries_;
  std::map<std::string, Value, std::less<>> values_;
};

}  // namespace limpet
