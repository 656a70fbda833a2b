// SPDX-License-Identifier: MIT
// The list of all variables, filled before main by the declarations in this folder: `limpet
// describe variables` and docs/variables.md come from it.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace limpet {

/// What its C++ type does not say about a variable.
struct TopicFacts {
  std::string unit{};                  ///< of a number, or of a record's fields; "" if it has none
  std::string frame{};                 ///< axes and origin; "" if it has none
  std::string rate{};                  ///< nominal: "10 Hz", "on change"
  std::vector<std::string> writers{};  ///< apps; `operator` for a person or the mission's flags
  /// It asks for something to be done when it comes: its time is that of reception. A sender on a
  /// shore whose clock is wrong is obeyed all the same.
  bool is_command = false;
};

/// One variable as another program meets it.
struct Variable {
  std::string name;
  std::string meaning;
  std::string type;                 ///< MOOS type and, if text or bytes, what they hold
  std::vector<std::string> fields;  ///< of a `key=value` record, in order
  TopicFacts facts;
};

/// Every declared variable by name.
[[nodiscard]] const std::map<std::string, Variable>& VariableCatalog();

/// Adds one; for Declare.
void AddToVariableCatalog(Variable variable);

}  // namespace limpet
