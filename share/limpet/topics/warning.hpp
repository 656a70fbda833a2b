// SPDX-License-Identifier: MIT
// What an operator may be warned of, declared once and next to who warns: `limpet describe
// warnings`, docs/warnings.md and the reports come from it. An id that is not declared does not
// compile.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limpet {

/// How much a warning or an event asks of an operator, least first.
enum class Severity {
  kNote,     ///< worth knowing; nothing has to be done
  kWarning,  ///< something works less well than it should: look at it when you can
  kAlarm     ///< vehicle, mission or data are at stake: act now
};

/// `note`, `warning` or `alarm`.
[[nodiscard]] std::string_view NameOf(Severity severity);
/// Nothing for any other word.
[[nodiscard]] std::optional<Severity> SeverityNamed(std::string_view name);

/// What an operator has to know about a warning beside its text of the moment; whole sentences.
struct WarningFacts {
  Severity severity = Severity::kWarning;
  /// Apps by process, behaviors by type; empty: every app.
  std::vector<std::string> raised_by{};
  std::string meaning{};
  std::string action{};  ///< what the operator should do
  std::string clears{};  ///< when it is over
};

/// A declared warning as the apps' lists show it.
struct WarningDeclaration {
  std::string id;  ///< of a family with its subject in angle brackets: `SILENT_<VARIABLE>`
  WarningFacts facts;

  [[nodiscard]] bool is_family() const { return id.ends_with('>'); }
  /// The id, or what the ids of a family begin with.
  [[nodiscard]] std::string_view stem() const {
    return std::string_view(id).substr(0, id.find('<'));
  }
  /// True for the id, or one of the family.
  [[nodiscard]] bool Covers(std::string_view raised_id) const {
    return is_family() ? raised_id.starts_with(stem()) : raised_id == id;
  }
};

/// The id of one warning. Made by a declaration alone, so that none can be raised without.
class WarningId {
 public:
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] Severity severity() const { return severity_; }

 private:
  friend class WarningFamily;
  friend WarningId DeclareWarning(std::string id, WarningFacts facts);
  WarningId(std::string name, Severity severity) : name_(std::move(name)), severity_(severity) {}

  std::string name_;
  Severity severity_;
};

/// Warnings that differ in what they are about: a variable, a process, a port.
class WarningFamily {
 public:
  [[nodiscard]] WarningId Of(std::string_view subject) const {
    return {stem_ + std::string(subject), severity_};
  }

 private:
  friend WarningFamily DeclareWarningFamily(std::string id, WarningFacts facts);
  WarningFamily(std::string stem, Severity severity)
      : stem_(std::move(stem)), severity_(severity) {}

  std::string stem_;
  Severity severity_;
};

/// For constants, which are made before main. REQUIRES: no warning of this id is declared, nor a
/// family of the same raiser that covers it.
[[nodiscard]] WarningId DeclareWarning(std::string id, WarningFacts facts);

/// `id` names the subject: `SILENT_<VARIABLE>`. Families of different raisers may have one stem.
/// REQUIRES: what DeclareWarning requires, for every id of the family.
[[nodiscard]] WarningFamily DeclareWarningFamily(std::string id, WarningFacts facts);

/// Every declaration of this program, by id, then by raiser.
[[nodiscard]] const std::vector<WarningDeclaration>& WarningCatalog();

/// The declaration of what `app` raised as `id`; null if this program has none.
[[nodiscard]] const WarningDeclaration* FindWarning(std::string_view app, std::string_view id);

}  // namespace limpet
