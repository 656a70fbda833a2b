// SPDX-License-Identifier: MIT
#include "limpet/topics/warning.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr std::array<std::string_view, 3> kSeverityNames{"note", "warning", "alarm"};

std::vector<WarningDeclaration>& WarningStore() {
  static std::vector<WarningDeclaration> catalog;
  return catalog;
}

bool ShareARaiser(const WarningFacts& a, const WarningFacts& b) {
  return a.raised_by.empty() || b.raised_by.empty() ||
         std::ranges::any_of(a.raised_by, [&b](const std::string& raiser) {
           return std::ranges::find(b.raised_by, raiser) != b.raised_by.end();
         });
}

bool AreInConflict(const WarningDeclaration& a, const WarningDeclaration& b) {
  if (!a.is_family() && !b.is_family()) {
    return a.id == b.id;
  }
  return ShareARaiser(a.facts, b.facts) && (a.Covers(b.stem()) || b.Covers(a.stem()));
}

void AddToCatalog(WarningDeclaration declaration) {
  std::vector<WarningDeclaration>& catalog = WarningStore();
  LIMPET_REQUIRE(std::ranges::none_of(catalog,
                                      [&declaration](const WarningDeclaration& known) {
                                        return AreInConflict(declaration, known);
                                      }),
                 "a warning is declared twice: " + declaration.id);
  const auto order = [](const WarningDeclaration& entry) {
    return std::tie(entry.id, entry.facts.raised_by);
  };
  const auto place = std::ranges::upper_bound(catalog, order(declaration), {}, order);
  catalog.insert(place, std::move(declaration));
}

}  // namespace

std::string_view NameOf(Severity severity) {
  return kSeverityNames.at(static_cast<std::size_t>(severity));
}

std::optional<Severity> SeverityNamed(std::string_view name) {
  const auto* const found = std::ranges::find(kSeverityNames, name);
  return found == kSeverityNames.end()
             ? std::nullopt
             : std::optional(static_cast<Severity>(found - kSeverityNames.begin()));
}

WarningId DeclareWarning(std::string id, WarningFacts facts) {
  WarningId declared(id, facts.severity);
  AddToCatalog({.id = std::move(id), .facts = std::move(facts)});
  return declared;
}

WarningFamily DeclareWarningFamily(std::string id, WarningFacts facts) {
  WarningDeclaration declaration{.id = std::move(id), .facts = std::move(facts)};
  LIMPET_REQUIRE(declaration.is_family(), "a family names its subject: " + declaration.id);
  WarningFamily declared(std::string(declaration.stem()), declaration.facts.severity);
  AddToCatalog(std::move(declaration));
  return declared;
}

const std::vector<WarningDeclaration>& WarningCatalog() { return WarningStore(); }

const WarningDeclaration* FindWarning(std::string_view app, std::string_view id) {
  const WarningDeclaration* found = nullptr;
  for (const WarningDeclaration& declared : WarningStore()) {
    if (!declared.Covers(id)) {
      continue;
    }
    const std::vector<std::string>& raisers = declared.facts.raised_by;
    if (raisers.empty() || std::ranges::find(raisers, app) != raisers.end()) {
      return &declared;
    }
    found = &declared;  // of an app that runs under another name, or of a behavior of the helm
  }
  return found;
}

}  // namespace limpet
