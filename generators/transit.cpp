// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <utility>

#include "limpet/helm/generator_registry.hpp"
#include "limpet/planning/transit_path.hpp"

namespace limpet {
namespace {

/// The way into the operating region for a vehicle outside it, where nobody before offers one that
/// may be flown.
class TransitGenerator final : public OptionGenerator {
 public:
  struct Params {
    template <class Visitor>
    void Describe(Visitor&) {}
  };
  explicit TransitGenerator(const Params&) {}

  void Offer(const Situation& now, const SearchGoals& goals,
             std::vector<Option>& options) override {
    const bool is_led_in =
        !IsInTransit(*now.region, now.pose) &&
        std::ranges::any_of(options, [&now](const Option& option) {
          return LeadsInto(*now.region, option) && !now.region->EntersZone(option.path);
        });
    if (!goals.leads_into_region || now.region->Outside(now.pose) <= 0.0 || is_led_in) {
      return;
    }
    if (std::optional<Option> transit =
            TransitPath(now.pose, {now.home.north, now.home.east}, *now.region, now.turn_radius)) {
      options.push_back(*std::move(transit));
    }
  }
};

}  // namespace

LIMPET_REGISTER_GENERATOR(TransitGenerator, "transit");

}  // namespace limpet
