// SPDX-License-Identifier: MIT
// What a behavior says of one option: as it bids, as the helm decides by it, as HELM_BIDS carries
// it, and as it is explained afterwards.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limpet {

/// What one reason contributes to a bid, in the unit of the bid.
struct Reason {
  std::string name;
  double value = 0.0;
};

/// Where next: the worth of one option, with reasons; or a veto. In metres of path, or in nats if
/// the behavior says so; behaviors that run together use one unit.
struct Bid {
  double value = 0.0;
  std::vector<Reason> why{};
  std::optional<std::string> veto{};  ///< why the option is forbidden
};

/// A bid as the helm weighs it.
struct WeightedBid {
  std::string behavior;  ///< its name in the mission
  double weight = 1.0;
  Bid bid;
  /// The bid's part of what the option is worth.
  [[nodiscard]] double Worth() const { return weight * bid.value; }
};

/// The reasons in a line, `useful=12.30 length=4.00`; of a veto its text.
[[nodiscard]] std::string WhyText(const Bid& bid);
/// The reasons of such a line. What is no pair of a name and a number is left out.
[[nodiscard]] std::vector<Reason> ReasonsIn(std::string_view line);

}  // namespace limpet
