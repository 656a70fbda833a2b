// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include "limpet/helm/generator_registry.hpp"
#include "limpet/planning/beam_search.hpp"

namespace limpet {
namespace {

/// Paths of the horizon's length by beam search over Dubins primitives.
class BeamGenerator final : public OptionGenerator {
 public:
  struct Params {
    Meters horizon{25.0};
    int width = 40;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("horizon_m", horizon, "Generator beam: length of its paths",
            InRange(Meters(5.0), Meters(500.0)));
      visit("beam_width", width, "Generator beam: states kept per depth of the search",
            InRange(1, 2000));
    }
  };
  explicit BeamGenerator(const Params& params) : params_(params) {}

  void Offer(const Situation& now, const SearchGoals& goals,
             std::vector<Option>& options) override {
    if (!goals.objective.SeeksAnything()) {
      return;
    }
    BeamParams beam;
    beam.turn_radius = now.turn_radius;
    beam.horizon = params_.horizon;
    beam.width = params_.width;
    std::ranges::move(BeamSearch(now.pose, *now.ground, *now.region, goals.objective, beam),
                      std::back_inserter(options));
  }

 private:
  Params params_;
};

}  // namespace

LIMPET_REGISTER_GENERATOR(BeamGenerator, "beam");

}  // namespace limpet
