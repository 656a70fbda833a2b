// SPDX-License-Identifier: MIT
// When the helm was parked or had stopped all, by what it says of itself: it may say nothing else
// then.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limpet {

/// A while in which the helm drove nothing, for one reason.
struct HelmStop {
  double begin = 0.0;         ///< as LoggedDecision::time [s]
  std::optional<double> end;  ///< nothing: it lasts
  std::string why;            ///< as IVPHELM_ALLSTOP says, else the helm's state
};

/// Gathered from IVPHELM_STATE and IVPHELM_ALLSTOP in the order in which they were written.
class HelmStops {
 public:
  /// Whatever else it is given it leaves alone.
  void Take(std::string_view variable, std::string_view value, double time);

  /// In order; where one reason follows another, one begins as the other ends.
  [[nodiscard]] const std::vector<HelmStop>& stops() const { return stops_; }
  /// Null if the helm drove at that time, or nobody said.
  [[nodiscard]] const HelmStop* At(double time) const;

 private:
  void Settle(double time);
  void End(double time, bool goes_on);

  std::string state_;   ///< that stops it, else empty
  std::string reason_;  ///< of an all-stop, else empty
  int iterations_ = 0;  ///< of the helm since the last stop began
  double last_ = 0.0;   ///< time of the last word
  std::vector<HelmStop> stops_;
};

}  // namespace limpet
