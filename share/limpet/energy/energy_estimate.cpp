// SPDX-License-Identifier: MIT
#include "limpet/energy/energy_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr Seconds kLongestGap(5.0);    ///< between two BATTERY; beyond it nothing is known of it
constexpr double kSlowest_mps = 0.15;  ///< slower is without way on
/// How much way, time and charge the prior is worth, and after how much they are forgotten.
constexpr double kPriorWay_m = 50.0, kPriorTime_s = 60.0, kPriorCharge = 0.15;
constexpr double kWayMemory_m = 1000.0, kTimeMemory_s = 1200.0;
/// A piece of way that is taken for itself: the way home may be against a current that the mean of
/// all ways knows little of.
constexpr double kPiece_m = 50.0;
constexpr double kAscent_mps = 0.15;
/// A current makes a difference from here on, and is told apart from none by so many sigmas.
constexpr double kLeastCurrent_mps = 0.05;
constexpr double kSigmas = 3.0;
/// The voltage is trusted to this share of a full charge.
constexpr double kVoltageTolerance = 0.15;
constexpr double kSmoothing_s = 20.0;

}  // namespace

EnergyEstimate::EnergyEstimate(const VehicleParams& vehicle, const BatterySheet& battery)
    : sheet_(battery),
      prior_(EnergyPrior::Of(vehicle, battery)),
      power_(vehicle, battery),
      moving_m_(kPriorWay_m),
      moving_still_m_(kPriorWay_m),
      moving_s_(kPriorWay_m / prior_.cruise.value()),
      moving_wh_(kPriorWay_m * prior_.metre_wh),
      idle_s_(kPriorTime_s),
      idle_wh_(kPriorTime_s * prior_.idle_w / kJoulesPerWh) {}

void EnergyEstimate::Hear(const NavState& nav, Seconds now) {
  if (nav_ && now > nav_->time && now - nav_->time < kLongestGap) {
    const double speed_mps = std::hypot(nav.u, nav.v);
    const double way_m = speed_mps * (now - nav_->time).value();
    const Way way{.course = nav.yaw + std::atan2(nav.v, nav.u),
                  .speed = MetersPerSecond(speed_mps)};
    way_m_ += way_m;
    still_m_ +=
        HasCurrent() && speed_mps >= kSlowest_mps ? way_m * power_.CostOf(*current_, way) : way_m;
  }
  nav_ = {now, nav};
}

std::optional<double> EnergyEstimate::ChargeByVoltage(const BatteryState& battery) const {
  if (!battery.volts || !battery.amperes) return std::nullopt;
  return sheet_.ChargeAt(*battery.volts + *battery.amperes * sheet_.resistance_ohm);
}

void EnergyEstimate::Hear(const BatteryState& battery, Seconds now) {
  first_charge_ = first_charge_.value_or(battery.charge);
  const std::optional<double> by_voltage = ChargeByVoltage(battery);
  if (battery_ && now > battery_->time) {
    const Seconds duration = now - battery_->time;
    if (battery.volts && battery.amperes && duration < kLongestGap) {
      Book(*battery.volts * *battery.amperes * duration.value() / kJoulesPerWh, duration);
    }
    if (!by_voltage) {  // then the charge alone tells
      const double dropped = *first_charge_ - battery.charge;
      used_wh_ = std::max(used_wh_, dropped * prior_.capacity_wh);
    } else {
      const double share = std::min(1.0, duration.value() / kSmoothing_s);
      const double excess = battery.charge - *by_voltage;
      gauge_excess_ = gauge_excess_ ? *gauge_excess_ + share * (excess - *gauge_excess_) : excess;
    }
  }
  way_m_ = still_m_ = 0.0;
  battery_ = {now, battery};
}

void EnergyEstimate::Book(double used_wh, Seconds duration) {
  used_wh_ += used_wh;
  if (way_m_ < kSlowest_mps * duration.value()) {
    const double kept = std::exp(-duration.value() / kTimeMemory_s);
    idle_s_ = kept * idle_s_ + duration.value();
    idle_wh_ = kept * idle_wh_ + used_wh;
    return;
  }
  const double kept = std::exp(-way_m_ / kWayMemory_m);
  moving_m_ = kept * moving_m_ + way_m_;
  moving_still_m_ = kept * moving_still_m_ + still_m_;
  moving_s_ = kept * moving_s_ + duration.value();
  moving_wh_ = kept * moving_wh_ + used_wh;
  piece_m_ += way_m_;
  piece_wh_ += used_wh;
  if (piece_m_ < kPiece_m) return;
  dearest_metre_wh_ = std::max(dearest_metre_wh_, piece_wh_ / piece_m_);
  piece_m_ = 0.0;
  piece_wh_ = 0.0;
}

double EnergyEstimate::CapacityWh() const {
  const double dropped = std::max(0.0, *first_charge_ - battery_->value.charge);
  const double learnt = (kPriorCharge * prior_.capacity_wh + used_wh_) / (kPriorCharge + dropped);
  // A gauge that sticks must not make the battery large.
  return std::min(learnt, sheet_.capacity_wh);
}

bool EnergyEstimate::HasCurrent() const {
  if (!current_) return false;
  const double speed_mps = std::hypot(current_->north, current_->east);
  return speed_mps >= std::max(kLeastCurrent_mps, kSigmas * current_->sd);
}

MetersPerSecond EnergyEstimate::Cruise() const { return MetersPerSecond(moving_m_ / moving_s_); }

CourseCost EnergyEstimate::CostsByCourse() const {
  return HasCurrent() ? power_.CostsOf(*current_, Cruise()) : CourseCost{};
}

// Never less than a metre was at times: nobody promises that a current will carry it.
double EnergyEstimate::HomeMetre(double course) const {
  const double dearest_so_far_wh = std::max(moving_wh_ / moving_m_, dearest_metre_wh_);
  if (!HasCurrent()) return dearest_so_far_wh;
  const double cost = power_.CostOf(*current_, {.course = course, .speed = Cruise()});
  return std::max(dearest_so_far_wh, cost * moving_wh_ / moving_still_m_);
}

std::optional<EnergyState> EnergyEstimate::At(const HomeLeg& home) const {
  if (!battery_) return std::nullopt;
  EnergyState state{.used_wh = used_wh_,
                    .capacity_wh = CapacityWh(),
                    .metre_wh = std::max(moving_wh_ / moving_m_, dearest_metre_wh_),
                    .idle_w = idle_wh_ / idle_s_ * kJoulesPerWh,
                    .charge = battery_->value.charge,
                    .gauge_excess = gauge_excess_};
  if (gauge_excess_) {
    state.charge -= std::max(0.0, *gauge_excess_ - kVoltageTolerance);
  }
  state.charge = std::clamp(state.charge, 0.0, 1.0);
  state.left_wh = state.charge * state.capacity_wh;
  state.reserve_wh = home.reserve_share * state.capacity_wh;
  const double last_s = std::max(0.0, home.depth.value()) / kAscent_mps + home.at_surface.value();
  const double last_wh = last_s * state.idle_w / kJoulesPerWh;
  const double home_metre_wh = HomeMetre(home.course);
  state.home_wh = home.distance.value() * home_metre_wh + last_wh;
  const double way_wh = std::max(0.0, state.left_wh - state.reserve_wh - last_wh);
  state.reach_m = way_wh / home_metre_wh;
  return state;
}

}  // namespace limpet
