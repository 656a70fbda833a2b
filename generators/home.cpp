// SPDX-License-Identifier: MIT
#include "limpet/helm/generator_registry.hpp"
#include "limpet/planning/home_path.hpp"

namespace limpet {
namespace {

/// The shortest way to each destination that a behavior asks for.
class HomeGenerator final : public OptionGenerator {
 public:
  struct Params {
    template <class Visitor>
    void Describe(Visitor&) {}
  };
  explicit HomeGenerator(const Params&) {}

  void Offer(const Situation& now, const SearchGoals& goals,
             std::vector<Option>& options) override {
    for (const Destination& to : goals.destinations) {
      options.push_back(HomePath(now.pose, to.north, to.east, *now.region, now.turn_radius));
    }
  }
};

}  // namespace

LIMPET_REGISTER_GENERATOR(HomeGenerator, "home");

}  // namespace limpet
