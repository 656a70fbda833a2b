// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include "limpet/helm/generator_registry.hpp"
#include "limpet/planning/target_tour.hpp"

namespace limpet {
namespace {

/// Short tours that look at the targets, nearest first.
class TourGenerator final : public OptionGenerator {
 public:
  struct Params {
    template <class Visitor>
    void Describe(Visitor&) {}
  };
  explicit TourGenerator(const Params&) {}

  void Offer(const Situation& now, const SearchGoals& goals,
             std::vector<Option>& options) override {
    std::ranges::move(TargetTours(now.pose, *now.region, goals.objective, now.turn_radius),
                      std::back_inserter(options));
  }
};

}  // namespace

LIMPET_REGISTER_GENERATOR(TourGenerator, "tour");

}  // namespace limpet
