// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include "limpet/helm/generator_registry.hpp"
#include "limpet/planning/gap_paths.hpp"

namespace limpet {
namespace {

/// Paths through what is still unseen, wherever it is: for the end of a survey, when the searches
/// named before find little.
class GapGenerator final : public OptionGenerator {
 public:
  struct Params {
    double below = 0.02;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("gap_below", below,
            "Generator gaps: offers when the first option so far finds less useful track than this "
            "per metre",
            InRange(0.0, 1.0));
    }
  };
  explicit GapGenerator(const Params& params) : params_(params) {}

  void Offer(const Situation& now, const SearchGoals& goals,
             std::vector<Option>& options) override {
    if (!goals.objective.SeeksAnything() || UsefulShare(now, options) >= params_.below) {
      return;
    }
    GapParams gaps;
    gaps.turn_radius = now.turn_radius;
    std::ranges::move(GapPaths(now.pose, *now.ground, *now.region, goals.objective, gaps),
                      std::back_inserter(options));
  }

 private:
  /// Metres of useful track per metre of the first option.
  static double UsefulShare(const Situation& now, const std::vector<Option>& options) {
    if (options.empty()) {
      return 0.0;
    }
    const DubinsPath& best = options.front().path;
    return SeenAlong(*now.ground)(best).new_area / (now.ground->swath() * best.length());
  }

  Params params_;
};

}  // namespace

LIMPET_REGISTER_GENERATOR(GapGenerator, "gaps");

}  // namespace limpet
