#include "BHV_Template.hpp"

#include <cmath>

#include "limpet/helm/registry.hpp"

namespace {

/// Metres of a path within `radius` of a place.
double MetresNear(const limpet::DubinsPath& path, const BHV_Template::Params& place) {
  constexpr double kStep = 0.25;  // [m]
  double metres = 0.0;
  path.Sample(kStep, [&](const limpet::Pose2& pose, double) {
    const double north = pose.north - place.north.value();
    const double east = pose.east - place.east.value();
    metres += std::hypot(north, east) < place.radius.value() ? kStep : 0.0;
  });
  return metres;
}

}  // namespace

std::optional<limpet::Bid> BHV_Template::Value(const limpet::Prospect& prospect,
                                               const limpet::Situation&) const {
  const double near = MetresNear(prospect.path(), params_);
  return limpet::Bid{.value = -params_.cost * near, .why = {{"metres_near", near}}, .veto = {}};
}

LIMPET_REGISTER_BEHAVIOR(BHV_Template);
