// SPDX-License-Identifier: MIT
#include "apps/pShare/share_tally.hpp"

#include <array>

namespace limpet {
namespace {

constexpr Seconds kMemory(30.0);

double& CountOf(ShareCounts& counts, ShareRefusal refusal) {
  const std::array<double*, kShareRefusals> all{
      &counts.malformed, &counts.not_sealed, &counts.sealed, &counts.old_version,
      &counts.forged,    &counts.elsewhere,  &counts.stale,  &counts.replayed,
      &counts.own,       &counts.unlisted,   &counts.looped, &counts.overflow};
  return *all.at(static_cast<std::size_t>(refusal));
}

}  // namespace

bool ShareTally::Note(ShareRefusal refusal, Seconds now, double how_many) {
  CountOf(counts, refusal) += how_many;
  if (refusal == ShareRefusal::kUnlisted || refusal == ShareRefusal::kLooped) {
    return false;
  }
  last_[refusal] = now;
  return true;
}

std::vector<ShareRefusal> ShareTally::TakeSettled(Seconds now) {
  std::vector<ShareRefusal> settled;
  std::erase_if(last_, [&](const auto& entry) {
    const bool is_settled = now - entry.second > kMemory;
    if (is_settled) {
      settled.push_back(entry.first);
    }
    return is_settled;
  });
  return settled;
}

}  // namespace limpet
