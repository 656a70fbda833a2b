// SPDX-License-Identifier: MIT
#include "tests/bench/change_worlds/verdict_tally.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limpet {
namespace {

using nlohmann::json;

constexpr std::array<const char*, 3> kStatuses{"confirmed", "removed", "new"};
constexpr double kSure = 0.95;

double Brier(const std::vector<Saying>& sayings) {
  double sum = 0.0;
  for (const Saying& saying : sayings)
    sum += std::pow(saying.probability - (saying.is_true ? 1.0 : 0.0), 2);
  return sum / static_cast<double>(std::max<std::size_t>(sayings.size(), 1));
}

/// Expected calibration error over ten bins of equal width.
double CalibrationError(const std::vector<Saying>& sayings) {
  constexpr int kBins = 10;
  std::array<double, kBins> excess{};
  for (const Saying& saying : sayings) {
    const int bin = std::min(static_cast<int>(saying.probability * kBins), kBins - 1);
    excess[static_cast<std::size_t>(bin)] += saying.probability - (saying.is_true ? 1.0 : 0.0);
  }
  double sum = 0.0;
  for (const double one : excess)
    sum += std::abs(one);
  return sum / static_cast<double>(std::max<std::size_t>(sayings.size(), 1));
}

bool IsVerdict(const std::string& decided) {
  return decided != "uncertain" && decided != "not_inspected" && decided != "nothing";
}

std::string StatedAbove(const std::vector<Saying>& decided, double least) {
  const auto is_meant = [least](const Saying& saying) { return saying.probability >= least; };
  const auto stated = std::ranges::count_if(decided, is_meant);
  const auto wrong = std::ranges::count_if(
      decided, [&](const Saying& saying) { return is_meant(saying) && !saying.is_true; });
  return fmt::format("stated at {:.2f} and more: {} wrong of {}\n", least, wrong, stated);
}

}  // namespace

void VerdictTally::AddChange(std::uint64_t seed, const json& change) {
  const std::string truth = change.at("expected").is_null() ? "nothing" : change.at("expected");
  const std::string decided = change.at("decided");
  ++verdicts_[truth][decided];
  if (!change.at("posterior").is_null() && truth != "moved" && decided != "not_inspected") {
    for (const char* status : kStatuses)
      sayings_[status].push_back({change.at("posterior").at(status), truth == status});
  }
  if (!IsVerdict(decided)) return;
  const double probability = change.at("probability");  // null of what no session has found
  decided_.push_back({probability, decided == truth});
  if (decided != truth && probability >= kSure) {
    wrong_.push_back(
        fmt::format("seed {}: {} said {} at {:.4f}", seed, truth, decided, probability));
  }
}

void VerdictTally::Add(std::uint64_t seed, const json& report) {
  for (const json& session : report.at("sessions")) {
    ++sessions_;
    ++ended_[session.at("ended")];
    if (!session.contains("changes")) continue;
    for (const json& change : session.at("changes"))
      AddChange(seed, change);
  }
}

std::string VerdictTally::Text() const {
  std::string text = fmt::format("{} sessions, ended:", sessions_);
  for (const auto& [how, count] : ended_)
    text += fmt::format(" {} {}", how, count);
  text += "\n\n| truth | what was decided |\n| --- | --- |\n";
  for (const auto& [truth, counts] : verdicts_) {
    text += fmt::format("| {} |", truth);
    for (const auto& [decided, count] : counts)
      text += fmt::format(" {} {}", decided, count);
    text += " |\n";
  }
  text += "\n| status | places | Brier | ECE |\n| --- | --- | --- | --- |\n";
  for (const auto& [status, sayings] : sayings_) {
    text += fmt::format("| {} | {} | {:.3f} | {:.3f} |\n", status, sayings.size(), Brier(sayings),
                        CalibrationError(sayings));
  }
  text += "\n" + StatedAbove(decided_, 0.99) + StatedAbove(decided_, kSure) +
          StatedAbove(decided_, 0.0);
  for (const std::string& wrong : wrong_)
    text += "  " + wrong + "\n";
  return text;
}

}  // namespace limpet
