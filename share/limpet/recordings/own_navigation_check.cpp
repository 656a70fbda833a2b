// SPDX-License-Identifier: MIT
#include "limpet/recordings/own_navigation_check.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>

namespace limpet {
namespace {

constexpr double kOwnWindow = 5.0;             ///< [s]
constexpr double kLongestBetweenSpeeds = 5.0;  ///< between two speeds [s]
constexpr double kLeastWay = 1.0;              ///< [m]
constexpr double kHardlyTurned = 0.995;        ///< mean resultant length of headings: about 6 deg

template <class Sample>
std::optional<SampleTimes> TimesIfAny(const std::vector<Sample>& samples) {
  return samples.empty() ? std::nullopt : std::optional(TimesOf(samples));
}

double PathOfSpeeds(const std::vector<TimedNumber>& speeds) {
  double path = 0.0;
  for (std::size_t i = 1; i < speeds.size(); ++i) {
    const double step = speeds[i].t - speeds[i - 1].t;
    if (step > 0.0 && step <= kLongestBetweenSpeeds)
      path += 0.5 * step * (speeds[i].value + speeds[i - 1].value);
  }
  return path;
}

/// Samples window by window; times rise.
class Windows {
 public:
  explicit Windows(const std::vector<TimedNumber>& samples) : samples_(samples) {}
  /// Calls `take` with each value in [from, to).
  template <class Take>
  void ForEach(double from, double to, Take take) {
    while (next_ < samples_.size() && samples_[next_].t < from)
      ++next_;
    for (; next_ < samples_.size() && samples_[next_].t < to; ++next_)
      take(samples_[next_].value);
  }

 private:
  const std::vector<TimedNumber>& samples_;
  std::size_t next_ = 0;
};

void ComparePlaces(const OwnNavigation& own, OwnNavigationCheck& check) {
  std::vector<double> speed_differences, course_differences;
  Windows speeds(own.speeds), headings(own.headings);
  const TimedPlace* start = &own.places.front();
  const TimedPlace* last = start;
  double way = 0.0;  // along the places of the window
  for (const TimedPlace& place : own.places) {
    const double step = (place.p_W - last->p_W).norm();
    way += step, check.path_of_places += step;
    last = &place;
    const double span = place.t - start->t;
    if (span >= 0.0 && span < kOwnWindow) continue;
    double sum = 0.0, count = 0.0;
    speeds.ForEach(start->t, place.t, [&](double speed) { sum += speed, count += 1.0; });
    std::complex<double> direction;
    double directions = 0.0;
    headings.ForEach(start->t, place.t, [&](double heading) {
      direction += std::polar(1.0, heading), directions += 1.0;
    });
    if (span > 0.0 && way >= kLeastWay && std::abs(direction) > kHardlyTurned * directions) {
      const Eigen::Vector2d went = place.p_W - start->p_W;
      const double course = std::atan2(went.y(), went.x());
      if (count > 0.0) speed_differences.push_back(std::abs(went.norm() / span - sum / count));
      course_differences.push_back(
          std::abs(std::remainder(course - std::arg(direction), 2.0 * std::numbers::pi)));
    }
    start = &place, way = 0.0;
  }
  check.speed = DifferencesOf(std::move(speed_differences));
  check.course = DifferencesOf(std::move(course_differences));
}

}  // namespace

std::optional<OwnNavigationCheck> CheckOwnNavigation(const OwnNavigation& own) {
  if (own.is_empty()) return std::nullopt;
  OwnNavigationCheck check;
  check.places = TimesIfAny(own.places);
  check.headings = TimesIfAny(own.headings);
  check.speeds = TimesIfAny(own.speeds);
  check.path_of_speeds = PathOfSpeeds(own.speeds);
  if (!own.places.empty()) ComparePlaces(own, check);
  return check;
}

}  // namespace limpet
