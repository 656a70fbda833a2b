// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace limpet {

/// What is decided about an object. Uncertain: looks say too little; not inspected: there was none
/// that could have said anything, so nothing is known that was not known before.
enum class Status { kUncertain, kNotInspected, kConfirmed, kRemoved, kNew, kMoved, kNothing };
/// True where nothing was decided.
[[nodiscard]] constexpr bool IsOpen(Status status) {
  return status == Status::kUncertain || status == Status::kNotInspected;
}
[[nodiscard]] std::string_view NameOf(Status status);
/// Nothing for a word that names no status.
[[nodiscard]] std::optional<Status> StatusFromName(std::string_view name);

/// How likely an observation is if an object is there now, and if none is.
struct PresenceLikelihood {
  double if_present = 0.0, if_absent = 0.0;
};

/// What became of a place from the former session to this one, as probabilities that sum to one
/// (docs/references.md). In a discovery session only `appeared` and `nothing` are non-zero and mean
/// "is there" and "is not".
struct StatusPosterior {
  double confirmed = 0.0, removed = 0.0, appeared = 0.0, nothing = 0.0;

  /// That an object is there now.
  [[nodiscard]] double present() const { return confirmed + appeared; }
  [[nodiscard]] double Entropy() const;  ///< [nats]
  [[nodiscard]] double sum() const { return confirmed + removed + appeared + nothing; }
  struct Share {
    Status status;
    double probability;
  };
  /// Of which status each probability is: whoever writes a posterior, names or ranks what it holds
  /// possible, does so by these, in this order.
  [[nodiscard]] std::array<Share, 4> shares() const;
  /// Each times the likelihood of an observation: the joint probabilities, whose sum is that of the
  /// observation.
  [[nodiscard]] StatusPosterior Times(const PresenceLikelihood& observation) const;
  /// Adds what holds with this probability.
  void Add(const StatusPosterior& other, double probability);
  /// Scaled so that they sum to one; all zero stays so.
  [[nodiscard]] StatusPosterior Normalized() const;
};

}  // namespace limpet
