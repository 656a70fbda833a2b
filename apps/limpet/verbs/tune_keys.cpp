// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/tune_keys.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limpet/core/config.hpp"
#include "limpet/report/report_json.hpp"
#include "limpet/sweeps/sweep.hpp"
#include "limpet/tuning/report_values.hpp"

namespace limpet {
namespace {

constexpr std::string_view kSomeName = "*";  ///< of a phase or a generator

/// Keys of reports in which nothing happened, judged by a truth and not.
std::vector<std::string> SampleKeys(const std::vector<std::string>& sessions) {
  std::set<std::string> keys;
  for (const bool has_truth : {true, false}) {
    RunScore run;
    for (const std::string& name : sessions) {
      SessionScore session;
      session.name = name;
      session.former = "another";
      session.has_truth = has_truth;
      session.wins.push_back({.source = std::string(kSomeName)});
      session.phases.push_back({.phase = std::string(kSomeName)});
      run.sessions.push_back(session);
    }
    const auto report = ReportValues::FromJson(MachineFreeReport(ReportJson(run)));
    if (!report) continue;
    for (const std::string& key : report->Keys())
      keys.insert(key);
  }
  return {keys.begin(), keys.end()};
}

/// As much of a key as every report has, if its own has it: `sessions.discovery.water`.
std::string Stem(const std::string& key) {
  constexpr std::size_t kParts = 3;
  const std::vector<std::string> parts = Split(key, '.');
  return fmt::format(
      "{}",
      fmt::join(parts.begin(),
                parts.begin() + static_cast<std::ptrdiff_t>(std::min(parts.size(), kParts)), "."));
}

bool CanBe(const std::string& key, const std::vector<std::string>& samples) {
  const std::string stem = Stem(key);
  const bool is_below = key != stem;
  return std::ranges::any_of(samples, [&](const std::string& sample) {
    return is_below ? Stem(sample) == stem : sample == key;
  });
}

/// The nearest key; else the shortest whose last part is the nearest to that of `key`.
std::string NearestKey(const std::string& key, const std::vector<std::string>& samples) {
  const auto last_of = [](const std::string& text) { return text.substr(text.rfind('.') + 1); };
  std::vector<std::string> keys, lasts;
  for (const std::string& sample : samples) {
    if (sample.find(kSomeName) != std::string::npos) continue;
    keys.push_back(sample);
    lasts.push_back(last_of(sample));
  }
  if (std::string whole = NearestWord(key, keys); !whole.empty()) return whole;
  const std::string last = NearestWord(last_of(key), lasts);
  std::string nearest;
  for (const std::string& candidate : keys) {
    const bool is_shorter = nearest.empty() || candidate.size() < nearest.size();
    if (!last.empty() && last_of(candidate) == last && is_shorter) nearest = candidate;
  }
  return nearest;
}

}  // namespace

std::optional<std::string> ImpossibleKey(const ReportExpression& expression,
                                         const std::vector<std::string>& sessions) {
  const std::vector<std::string> samples = SampleKeys(sessions);
  for (const std::string& key : expression.keys()) {
    if (CanBe(key, samples)) continue;
    const std::string nearest = NearestKey(key, samples);
    return fmt::format("`{}`, at {}: report.json has no `{}`{}", expression.text(),
                       expression.text().find(key) + 1, key,
                       nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest));
  }
  return std::nullopt;
}

}  // namespace limpet
