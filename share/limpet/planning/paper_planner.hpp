// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/planning/ground.hpp"
#include "limpet/planning/option.hpp"
#include "limpet/planning/region.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {

enum class PaperGain {
  kCoverage,   ///< eq. (17): G
  kDiscovery,  ///< eq. (20): G exp(lambda A)
  kChange,     ///< eq. (23): G exp(lambda ((1 - theta) A' + A))
};

struct PaperParams {
  Meters turn_radius{3.0};
  int nodes = 100;
  Meters max_edge{4.0};  ///< of 3 to 15 m this served the paper's planner best
  double lambda = 1.0;
  PaperGain gain = PaperGain::kCoverage;
  /// Gain over the bottom alone (as printed) or over the layers of the band.
  bool counts_band = false;
};

/// The paper's planner as printed, P0 of paper.md: no rewiring, gain at the nodes only, the first
/// node executed, the best branch kept for the next decision.
class PaperPlanner {
 public:
  PaperPlanner(const PaperParams& params, const Region& region, Random random);
  /// The motion to the next view, or nothing if no view could be reached. `opis` are the objects
  /// believed in (mapped ones first) and `covered` is theta.
  [[nodiscard]] std::optional<Option> Next(const Pose2& start, const Ground& ground,
                                           const std::vector<OpiBelief>& opis, double covered);
  /// Gain of the branch that Next chose (nats, logarithm of L).
  [[nodiscard]] double log_gain() const { return log_gain_; }

 private:
  PaperParams params_;
  Region region_;
  Random random_;
  std::vector<Pose2> kept_;  ///< rest of the best branch
  double log_gain_ = 0.0;
};

}  // namespace limpet
