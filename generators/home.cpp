// SPDX-License-Identifier: MIT
#include <optional>

#include "limpet/helm/generator_registry.hpp"
#include "limpet/planning/home_path.hpp"
#include "limpet/planning/on_path.hpp"

namespace limpet {
namespace {

/// The shortest way to each destination that a behavior asks for: one sought anew, or the rest of
/// the one in force. Sought anew in the middle of a turn, a way often leads round in a circle.
class HomeGenerator final : public OptionGenerator {
 public:
  struct Params {
    template <class Visitor>
    void Describe(Visitor&) {}
  };
  explicit HomeGenerator(const Params&) {}

  void Offer(const Situation& now, const SearchGoals& goals,
             std::vector<Option>& options) override {
    travelled_ = now.travelled;
    for (const Destination& to : goals.destinations) {
      Option home = HomePath(now.pose, {to.north, to.east}, *now.region, now.turn_radius);
      const std::optional<DubinsPath> rest = RestInForce(now, to);
      if (rest && rest->length() < home.path.length()) {
        home.path = *rest;
        home.estimate = -home.path.length();
      }
      options.push_back(std::move(home));
    }
  }
  void OnChoice(const Option& option) override {
    in_force_ = option.source == kHomeSource ? option.path : DubinsPath();
    chosen_at_ = travelled_;
  }

 private:
  /// What is left of the path in force, if the vehicle is on it and it still leads there.
  [[nodiscard]] std::optional<DubinsPath> RestInForce(const Situation& now,
                                                      const Destination& to) const {
    constexpr double kThere_m = 0.1;
    if (in_force_.segments().empty()) return std::nullopt;
    DubinsPath rest = in_force_.Rest(now.travelled - chosen_at_);
    const bool leads_there =
        Distance(rest.end(), {.north = to.north, .east = to.east, .yaw = 0.0}) < kThere_m;
    if (!IsOnPath(rest, now.pose) || !leads_there || now.region->EntersZone(rest))
      return std::nullopt;
    return rest;
  }

  double travelled_ = 0.0, chosen_at_ = 0.0;  ///< path flown since some fixed moment [m]
  DubinsPath in_force_;
};

}  // namespace

LIMPET_REGISTER_GENERATOR(HomeGenerator, "home");

}  // namespace limpet
