// SPDX-License-Identifier: MIT
#include "limpet/report/html_warnings.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "limpet/figures/svg_canvas.hpp"

namespace limpet {
namespace {

/// Every time that an app raised one warning.
struct WarningHistory {
  const WarningRecord* latest = nullptr;
  int times = 0;
  Seconds first;  ///< MOOS time
  Seconds stood;  ///< in all
};

std::vector<WarningHistory> Histories(const std::vector<WarningRecord>& warnings, Seconds end) {
  std::vector<WarningHistory> histories;
  for (const WarningRecord& warning : warnings) {
    auto history = std::ranges::find_if(histories, [&warning](const WarningHistory& known) {
      return known.latest->app == warning.app && known.latest->id == warning.id;
    });
    if (history == histories.end()) {
      histories.push_back({.latest = &warning, .times = 0, .first = warning.from, .stood = {}});
      history = histories.end() - 1;
    }
    history->latest = &warning;
    ++history->times;
    history->stood += std::max(warning.to.value_or(end) - warning.from, Seconds(0.0));
  }
  std::ranges::stable_sort(histories, std::greater{},
                           [](const WarningHistory& history) { return history.latest->severity; });
  return histories;
}

std::string Advice(const WarningRecord& warning) {
  const WarningDeclaration* declared = FindWarning(warning.app, warning.id);
  return declared == nullptr ? ""
                             : fmt::format("<br><span class=\"muted\">{} {}</span>",
                                           EscapedMarkup(declared->facts.meaning),
                                           EscapedMarkup(declared->facts.action));
}

std::string Row(const WarningHistory& history, Seconds begun) {
  const WarningRecord& warning = *history.latest;
  const std::string over =
      warning.to ? fmt::format("{:.0f}", (*warning.to - begun).value()) : "stands";
  return fmt::format(
      "<tr><td>{0} {1}</td><td class=\"left\"><span class=\"{2}\">{2}</span></td><td>{3}</td>"
      "<td>{4:.0f}</td><td>{5}</td><td>{6:.0f}</td><td class=\"left text\">{7}{8}</td></tr>\n",
      EscapedMarkup(warning.app), EscapedMarkup(warning.id), NameOf(warning.severity),
      history.times, (history.first - begun).value(), over, history.stood.value(),
      EscapedMarkup(warning.text), Advice(warning));
}

}  // namespace

std::string WarningsTable(const std::vector<WarningRecord>& warnings, Seconds begun, Seconds end) {
  if (warnings.empty()) {
    return "<h3>Warnings</h3>\n<p>No app warned of anything.</p>\n";
  }
  std::string out =
      "<h3>Warnings</h3>\n<div class=\"scroll\"><table><tr><th>app, warning<th class=\"left\">"
      "severity<th>times<th>first [s]<th>over [s]<th>stood [s]<th class=\"left\">what it said "
      "last, "
      "what it means and what to do</tr>\n";
  for (const WarningHistory& history : Histories(warnings, end)) {
    out += Row(history, begun);
  }
  return out + "</table></div>\n";
}

}  // namespace limpet
