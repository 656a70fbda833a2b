// SPDX-License-Identifier: MIT
#include "limpet/recordings/recording_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "estimation/navigation/velocity_gate.hpp"
#include "limpet/recordings/depth_rates.hpp"

namespace limpet {
namespace {

constexpr double kLongestBridged = 1.0;  ///< between two velocities [s]

/// Adds up a path, velocity by velocity.
class PathMeter {
 public:
  void Add(double t, const Eigen::Vector3d& velocity) {
    const double speed = velocity.head<2>().norm(), step = t - t_;
    if (has_begun_ && step > 0.0) {
      if (step <= kLongestBridged) {
        path_.length += 0.5 * (speed + speed_) * step;
        path_.covered += step;
      } else {
        path_.left_out += step;
      }
    }
    has_begun_ = true, t_ = t, speed_ = speed;
  }
  [[nodiscard]] const PathLength& path() const { return path_; }

 private:
  PathLength path_;
  bool has_begun_ = false;
  double t_ = 0.0, speed_ = 0.0;
};

void JudgeVelocities(const std::vector<DvlPing>& pings, DvlCheck& check) {
  VelocityGate gate{VelocityGateParams()};
  PathMeter all, gated;
  double last = pings.front().t;
  for (const DvlPing& ping : pings) {
    check.longest_without_velocity = std::max(check.longest_without_velocity, ping.t - last);
    if (!ping.v_D) continue;
    last = ping.t;
    all.Add(ping.t, *ping.v_D);
    const auto verdict = gate.Judge(ping.t, *ping.v_D);
    switch (verdict) {
      case VelocityGate::Verdict::kGood:
        ++check.gate.good;
        break;
      case VelocityGate::Verdict::kRefused:
        ++check.gate.refused;
        break;
      case VelocityGate::Verdict::kContested:
        ++check.gate.contested;
        break;
      case VelocityGate::Verdict::kBelieved:
        ++check.gate.believed;
        break;
    }
    const bool is_used =
        verdict == VelocityGate::Verdict::kGood || verdict == VelocityGate::Verdict::kBelieved;
    if (is_used) gated.Add(ping.t, *ping.v_D);
  }
  check.path = all.path();
  check.gated_path = gated.path();
}

void CompareBeams(const std::vector<DvlPing>& pings, DvlCheck& check) {
  check.geometry = BeamGeometry::Estimate(pings);
  std::vector<double> four, three, contradiction;
  for (const DvlPing& ping : pings) {
    const auto good = std::ranges::count_if(
        ping.beam_speeds, [](const std::optional<double>& speed) { return speed.has_value(); });
    ++(good == 4 ? check.four_beams : good == 3 ? check.three_beams : check.fewer_beams);
    if (!ping.v_D && good >= 3) ++check.velocity_from_beams;
    if (!check.geometry) continue;
    if (const auto length = check.geometry->Contradiction(ping)) contradiction.push_back(*length);
    const auto velocity = check.geometry->Velocity(ping);
    if (!velocity || !ping.v_D) continue;
    (good == 4 ? four : three).push_back((*velocity - *ping.v_D).norm());
  }
  check.four = DifferencesOf(std::move(four));
  check.three = DifferencesOf(std::move(three));
  check.contradiction = DifferencesOf(std::move(contradiction));
}

/// Finds, among the rules that an instrument may follow, the one that explains its altitudes best.
std::optional<AltitudeRule> CompareAltitudes(const std::vector<DvlPing>& pings,
                                             const std::optional<BeamGeometry>& geometry) {
  std::array<std::vector<double>, 4> differences;
  double upright = 1.0;  // cosine of the beams from the vertical
  if (geometry) {
    upright = 0.0;
    for (const Radians tilt : geometry->tilts())
      upright += 0.25 * std::cos(tilt.value());
  }
  for (const DvlPing& ping : pings) {
    double least = 0.0, sum = 0.0;
    int beams = 0;
    for (const std::optional<double>& range : ping.beam_ranges) {
      if (!range) continue;
      least = beams == 0 ? *range : std::min(least, *range);
      sum += *range;
      ++beams;
    }
    if (!ping.altitude || beams < 3) continue;
    const std::array explained{least, sum / beams, upright * least, upright * sum / beams};
    for (std::size_t rule = 0; rule < explained.size(); ++rule)
      differences[rule].push_back(std::abs(*ping.altitude - explained[rule]));
  }
  if (differences.front().empty()) return std::nullopt;
  constexpr std::array kRules{"the least of the beams", "the mean of the beams",
                              "the least of the beams, made upright",
                              "the mean of the beams, made upright"};
  std::optional<AltitudeRule> best;
  for (std::size_t rule = 0; rule < kRules.size(); ++rule) {
    const Differences found = DifferencesOf(differences[rule]);
    if (!best || found.within_95 < best->differences.within_95) {
      best = AltitudeRule{.rule = kRules[rule], .differences = found};
    }
  }
  return best;
}

DvlCheck CheckDvl(const std::vector<DvlPing>& pings) {
  DvlCheck check;
  check.times = TimesOf(pings);
  for (const DvlPing& ping : pings) {
    if (ping.v_D) ++check.with_velocity;
    if (ping.altitude) ++check.with_altitude;
  }
  CompareBeams(pings, check);
  check.altitude = CompareAltitudes(pings, check.geometry);
  JudgeVelocities(pings, check);
  return check;
}

std::optional<VerticalAgreement> CompareVertically(const Recording& recording) {
  double rate_rate = 0.0, rate_speed = 0.0, speed_speed = 0.0;
  VerticalAgreement agreement;
  DepthRates rates(recording.depths);
  for (const DvlPing& ping : recording.pings) {
    const auto rate = ping.v_D ? rates.At(ping.t) : std::nullopt;
    if (!rate) continue;
    const double speed = ping.v_D->z();
    rate_rate += *rate * *rate;
    rate_speed += *rate * speed;
    speed_speed += speed * speed;
    ++agreement.count;
  }
  const double scale = std::sqrt(rate_rate * speed_speed);
  if (!(scale > 0.0)) return std::nullopt;
  agreement.slope = rate_speed / rate_rate;
  agreement.correlation = rate_speed / scale;
  return agreement;
}

DepthCheck CheckDepth(const std::vector<DepthReading>& depths) {
  DepthCheck check;
  check.times = TimesOf(depths);
  const auto [least, greatest] = std::ranges::minmax(depths, {}, &DepthReading::depth);
  check.least = least.depth, check.greatest = greatest.depth;
  DepthRates rates(depths);
  for (const DepthReading& row : depths) {
    const double rate = rates.At(row.t).value_or(0.0);
    check.fastest_down = std::max(check.fastest_down, rate);
    check.fastest_up = std::max(check.fastest_up, -rate);
  }
  return check;
}

}  // namespace

RecordingCheck Check(const Recording& recording) {
  RecordingCheck check;
  if (!recording.pings.empty()) check.dvl = CheckDvl(recording.pings);
  if (!recording.depths.empty()) check.depth = CheckDepth(recording.depths);
  check.own = CheckOwnNavigation(recording.own);
  check.vertical = CompareVertically(recording);
  return check;
}

}  // namespace limpet
