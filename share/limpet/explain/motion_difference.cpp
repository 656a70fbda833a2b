// SPDX-License-Identifier: MIT
#include "limpet/explain/motion_difference.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/decimal_text.hpp"
#include "limpet/core/frames.hpp"

namespace limpet {
namespace {

struct SteeredVariable {
  const char* name;
  const char* unit;
  double much;  ///< beyond this it is another value [unit]
  std::optional<double> HelmMotion::*chosen;
};
constexpr SteeredVariable kVariables[] = {{"course", " deg", 5.0, &HelmMotion::course_deg},
                                          {"speed", " m/s", 0.05, &HelmMotion::speed_mps},
                                          {"depth", " m", 0.1, &HelmMotion::depth_m}};

bool AreMuchTheSame(const std::optional<double>& a, const std::optional<double>& b,
                    const SteeredVariable& variable) {
  if (!a || !b) return a.has_value() == b.has_value();
  const bool is_course = variable.chosen == &HelmMotion::course_deg;
  const double difference =
      is_course ? DegreesFromRadians(WrapAngle(RadiansFromDegrees(*a - *b))) : *a - *b;
  return std::abs(difference) < variable.much;
}

std::string ChosenText(const std::optional<double>& value) {
  return value ? DecimalText(*value, 2) : "nobody's";
}

void Join(const std::string& text, std::string& all) { all += (all.empty() ? "" : ", ") + text; }

using Wishes = std::set<std::pair<std::string, std::string>>;  // behavior, variables

Wishes WishesOf(const HelmMotion& motion) {
  Wishes wishes;
  for (const MotionOpinion& opinion : motion.opinions) {
    wishes.emplace(opinion.behavior, opinion.variables);
  }
  return wishes;
}

/// `lap bids on course+speed no more`; of a behavior all of whose wishes came or went `lap bids no
/// more`.
std::string WishesOnlyIn(const Wishes& some, const Wishes& others, const char* ending) {
  std::string text;
  std::set<std::string> told;
  for (const auto& [behavior, variables] : some) {
    if (others.contains({behavior, variables})) continue;
    const bool is_there = std::ranges::any_of(
        others, [&name = behavior](const auto& other) { return other.first == name; });
    if (is_there) {
      Join(fmt::format("{} bids on {}{}", behavior, variables, ending), text);
    } else if (told.insert(behavior).second) {
      Join(fmt::format("{} bids{}", behavior, ending), text);
    }
  }
  return text;
}

/// What each behavior that wants one value of a variable gets, weighed.
std::map<std::string, double> PullsOn(const SteeredVariable& variable, const HelmMotion& motion) {
  std::map<std::string, double> pulls;
  for (const MotionOpinion& opinion : motion.opinions) {
    if (opinion.variables == variable.name && opinion.summit) {
      pulls[opinion.behavior] += opinion.weight * opinion.value;
    }
  }
  return pulls;
}

/// `speed: slow counts most, not lap`; empty if that is as it was.
std::string OtherDecider(const SteeredVariable& variable, const HelmMotion& before,
                         const HelmMotion& now) {
  constexpr double kClearly = 1.1;
  const auto by_pull = [](const auto& pull) { return pull.second; };
  const std::map<std::string, double> pulls = PullsOn(variable, now);
  const std::map<std::string, double> former = PullsOn(variable, before);
  if (pulls.empty() || former.empty()) return "";
  const auto most = std::ranges::max_element(pulls, {}, by_pull);
  const auto former_most = std::ranges::max_element(former, {}, by_pull);
  const auto still = pulls.find(former_most->first);
  const bool is_same =
      still != pulls.end() && (still == most || most->second <= kClearly * still->second);
  return is_same ? ""
                 : fmt::format("{}: {} counts most, not {}", variable.name, most->first,
                               former_most->first);
}

}  // namespace

const char* UnitOf(std::string_view variable) {
  const auto found = std::ranges::find(kVariables, variable, &SteeredVariable::name);
  return found == std::end(kVariables) ? "" : found->unit;
}

bool IsPresentCourse(const HelmMotion& motion, std::size_t opinion) {
  const MotionOpinion& asked = motion.opinions[opinion];
  if (asked.variables != "course") return false;
  return std::any_of(motion.opinions.begin(),
                     motion.opinions.begin() + static_cast<std::ptrdiff_t>(opinion),
                     [&](const MotionOpinion& other) {
                       return other.behavior == asked.behavior && other.variables == "course";
                     });
}

std::string DifferenceBetween(const HelmMotion& before, const HelmMotion& now) {
  const Wishes then = WishesOf(before), wishes = WishesOf(now);
  std::string text = WishesOnlyIn(wishes, then, "");
  if (const std::string gone = WishesOnlyIn(then, wishes, " no more"); !gone.empty()) {
    Join(gone, text);
  }
  if (!text.empty()) return text;
  for (const SteeredVariable& variable : kVariables) {
    if (const std::string other = OtherDecider(variable, before, now); !other.empty()) {
      Join(other, text);
    }
  }
  if (!text.empty()) return text;
  for (const SteeredVariable& variable : kVariables) {
    const auto &was = before.*variable.chosen, &is = now.*variable.chosen;
    if (!AreMuchTheSame(was, is, variable)) {
      Join(fmt::format("{} {} -> {}{}", variable.name, ChosenText(was), ChosenText(is),
                       variable.unit),
           text);
    }
  }
  return text;
}

}  // namespace limpet
