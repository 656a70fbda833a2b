// SPDX-License-Identifier: MIT
#include "limpet/tuning/race.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

double MeanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Runs that may fail before the share of those that do not is below what it must be.
std::size_t AllowedFailures(const RaceRules& rules) {
  constexpr double kRounding = 1e-9;
  return static_cast<std::size_t>(
      std::floor((1.0 - rules.share) * static_cast<double>(rules.runs) + kRounding));
}

}  // namespace

std::vector<double> Contender::Costs() const {
  std::vector<double> costs;
  for (const RunOutcome& outcome : outcomes) {
    if (outcome.cost) costs.push_back(*outcome.cost);
  }
  return costs;
}

std::size_t Contender::Failures() const {
  return static_cast<std::size_t>(std::ranges::count_if(outcomes, [](const RunOutcome& outcome) {
    return !outcome.cost || !outcome.keeps_constraints;
  }));
}

std::vector<double> PairedDifferences(const Contender& a, const Contender& b) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < std::min(a.outcomes.size(), b.outcomes.size()); ++i) {
    const auto &of_a = a.outcomes[i].cost, &of_b = b.outcomes[i].cost;
    if (of_a && of_b) differences.push_back(*of_a - *of_b);
  }
  return differences;
}

Race::Race(const RaceRules& rules, Contender by_default, Fly fly)
    : rules_(rules), fly_(std::move(fly)) {
  LIMPET_REQUIRE(rules.runs > 0, "a race without runs");
  by_default.is_default = true;
  contenders_.push_back(std::move(by_default));
}

void Race::Enter(const std::vector<SettingValues>& settings) {
  for (const SettingValues& setting : settings)
    contenders_.push_back({.setting = setting});
}

std::size_t Race::LeastRuns() const {
  std::size_t least = rules_.runs;
  for (const Contender& contender : contenders_) {
    if (contender.is_in()) least = std::min(least, contender.outcomes.size());
  }
  return least;
}

bool Race::Run() {
  const std::size_t step = std::max<std::size_t>(1, rules_.runs / 10);
  for (std::size_t flown = LeastRuns(); flown < rules_.runs; flown = LeastRuns()) {
    const std::size_t until =
        std::min(rules_.runs, flown < rules_.first_block ? rules_.first_block : flown + step);
    std::vector<Flight> flights;
    for (std::size_t i = 0; i < contenders_.size(); ++i) {
      if (!contenders_[i].is_in()) continue;
      for (std::size_t seed = contenders_[i].outcomes.size(); seed < until; ++seed)
        flights.push_back({.contender = i, .seed_index = seed});
    }
    const std::vector<RunOutcome> outcomes = fly_(contenders_, flights);
    if (outcomes.size() != flights.size()) return false;
    for (std::size_t i = 0; i < flights.size(); ++i)
      contenders_[flights[i].contender].outcomes.push_back(outcomes[i]);
    EliminateBreakers();
    EliminateLosers();
  }
  return true;
}

void Race::EliminateBreakers() {
  const std::size_t allowed = AllowedFailures(rules_);
  for (Contender& contender : contenders_) {
    const std::size_t failures = contender.Failures();
    if (contender.is_default || !contender.is_in() || failures <= allowed) continue;
    contender.eliminated = fmt::format("{} of {} runs break a constraint or have no objective",
                                       failures, contender.outcomes.size());
  }
}

std::optional<std::size_t> Race::Leader() const {
  std::optional<std::size_t> leader;
  const std::size_t allowed = AllowedFailures(rules_);
  const auto is_ahead = [](const Contender& a, const Contender& b) {
    if (a.outcomes.size() != b.outcomes.size()) return a.outcomes.size() > b.outcomes.size();
    return MeanOf(a.Costs()) < MeanOf(b.Costs());
  };
  for (std::size_t i = 0; i < contenders_.size(); ++i) {
    const Contender& contender = contenders_[i];
    if (!contender.is_in() || contender.Costs().empty() || contender.Failures() > allowed) continue;
    if (!leader || is_ahead(contender, contenders_[*leader])) leader = i;
  }
  return leader;
}

void Race::EliminateLosers() {
  const std::optional<std::size_t> leader = Leader();
  if (!leader) return;
  const auto others = std::ranges::count_if(contenders_, &Contender::is_in) - 1;
  for (Contender& contender : contenders_) {
    if (contender.is_default || !contender.is_in() || &contender == &contenders_[*leader]) continue;
    const std::vector<double> differences = PairedDifferences(contender, contenders_[*leader]);
    const std::optional<double> chance = ChanceOfSoGreatAMean(differences);
    if (!chance || *chance >= rules_.error_rate / static_cast<double>(others)) continue;
    contender.eliminated = fmt::format("worse than the leader by {:.3g} over {} seeds (p {:.1g})",
                                       MeanOf(differences), differences.size(), *chance);
  }
}

std::optional<std::size_t> Race::Best(bool counts_default) const {
  std::optional<std::size_t> best;
  const std::size_t allowed = AllowedFailures(rules_);
  for (std::size_t i = 0; i < contenders_.size(); ++i) {
    const Contender& contender = contenders_[i];
    const bool counts = contender.is_in() && contender.outcomes.size() == rules_.runs &&
                        !contender.Costs().empty() && contender.Failures() <= allowed &&
                        (counts_default || !contender.is_default);
    if (!counts) continue;
    if (!best || MeanOf(contender.Costs()) < MeanOf(contenders_[*best].Costs())) best = i;
  }
  return best;
}

}  // namespace limpet
