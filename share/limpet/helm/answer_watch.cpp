// SPDX-License-Identifier: MIT
#include "limpet/helm/answer_watch.hpp"

#include <fmt/format.h>

namespace limpet {
namespace {

constexpr double kRestPerTaken = 100.0;

std::string RestText(Seconds took) {
  return fmt::format("its answers take long, the last {:.1f} s: not asked for {:.0f} s",
                     took.value(), kRestPerTaken * took.value());
}

}  // namespace

std::optional<std::string> AnswerWatch::RestOf(const std::string& owner) const {
  constexpr int kTooOften = 2;
  const auto found = late_.find(owner);
  if (found == late_.end() || found->second.in_a_row < kTooOften) return std::nullopt;
  const Lateness& late = found->second;
  if (Now() - late.since >= kRestPerTaken * late.took) return std::nullopt;
  return RestText(late.took);
}

std::optional<std::string> AnswerWatch::Judge(const std::string& owner, Seconds took,
                                              bool is_late) {
  if (!is_late) {
    late_.erase(owner);
    return std::nullopt;
  }
  Lateness& late = late_[owner];
  late = {.in_a_row = late.in_a_row + 1, .took = took, .since = Now()};
  std::optional<std::string> rest = RestOf(owner);
  return rest ? rest : ComplaintOf(took);
}

std::optional<std::string> AnswerWatch::ComplaintOf(Seconds took) {
  if (took <= kLate) return std::nullopt;
  return fmt::format("it has kept the helm for {:.2f} s, more than {:g} s", took.value(),
                     kLate.value());
}

}  // namespace limpet
