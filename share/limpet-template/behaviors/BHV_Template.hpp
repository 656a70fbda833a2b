#pragma once

#include <optional>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

/// Would rather not fly near one place, such as a buoy with its lines: each metre that an option
/// spends there costs it `cost` metres of worth. It forbids nothing.
class BHV_Template final : public limpet::Behavior {
 public:
  struct Params {
    limpet::Meters north{0.0};
    limpet::Meters east{0.0};
    limpet::Meters radius{5.0};
    double cost = 1.0;
    template <class Visitor>
    void Describe(Visitor& visit) {
      using limpet::InRange;
      using limpet::Meters;
      visit.Required("north_m", north, "The place, from the datum",
                     InRange(Meters(-1e5), Meters(1e5)));
      visit.Required("east_m", east, "The place, from the datum",
                     InRange(Meters(-1e5), Meters(1e5)));
      visit("radius_m", radius, "How far around it", InRange(Meters(0.1), Meters(1000.0)));
      visit("cost", cost, "Of a metre there, in metres of path", InRange(0.0, 100.0));
    }
  };
  explicit BHV_Template(const Params& params) : params_(params) {}

  [[nodiscard]] std::optional<limpet::Bid> Value(const limpet::Prospect& prospect,
                                                 const limpet::Situation& now) const override;

 private:
  Params params_;
};
