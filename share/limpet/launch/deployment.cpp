// SPDX-License-Identifier: MIT
#include "limpet/launch/deployment.hpp"

#include <utility>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

constexpr int kHelmIsThere = 2;  // the first word may be what a former helm left

bool IsDeployed(const DeploymentSigns& signs) { return ParseFlag(signs.deploy).value_or(false); }

bool IsUnderWay(const DeploymentSigns& signs) {
  return IsDeployed(signs) && (!signs.has_helm || signs.helm_stop == topics::kNoAllStop) &&
         (!signs.has_survey || (!signs.phase.empty() && signs.phase != NameOf(SurveyPhase::kIdle)));
}

std::string Shown(const std::string& value) { return value.empty() ? "not heard" : value; }

std::string WhyNot(const DeploymentSigns& signs) {
  std::string text = "DEPLOY " + Shown(signs.deploy);
  if (signs.has_survey) {
    text += ", SURVEY_PHASE " + Shown(signs.phase);
  }
  if (signs.has_helm) {
    text += signs.helm_words < kHelmIsThere ? ", the helm has not iterated"
                                            : ", IVPHELM_ALLSTOP " + Shown(signs.helm_stop);
  }
  return text;
}

}  // namespace

Deployment::Step Deployment::Write(std::string says, Seconds now) {
  ++writes_;
  last_write_ = now;
  return {.writes = true, .says = std::move(says)};
}

Deployment::Step Deployment::WarnIfDue(const DeploymentSigns& signs, Seconds now) {
  if (!warning_.empty() || now - *ready_since_ <= kWarnAfter) {
    return {};
  }
  warning_ = "the mission is not under way: " + WhyNot(signs);
  return {.writes = false, .says = warning_};
}

Deployment::Step Deployment::Mind(const DeploymentSigns& signs, Seconds now) {
  if (is_done_ || (!signs.is_all_up && !ready_since_)) {
    return {};
  }
  ready_since_ = ready_since_.value_or(now);
  if (writes_ > 0 && (IsUnderWay(signs) || signs.has_ended)) {
    is_done_ = true;
    const bool was_late = !warning_.empty();
    warning_.clear();
    return {.writes = false, .says = was_late ? "the mission is under way" : ""};
  }
  const bool helm_hears = !signs.has_helm || signs.helm_words >= kHelmIsThere;
  if (writes_ == 0 && helm_hears) {
    return Write("all up; DEPLOY = true", now);
  }
  const bool is_lost =
      !IsDeployed(signs) || (signs.has_survey && signs.phase == NameOf(SurveyPhase::kIdle));
  if (writes_ > 0 && is_lost && writes_ < kMostWrites && now - last_write_ > kAgainAfter) {
    return Write(fmt::format("not under way yet ({}); DEPLOY = true again", WhyNot(signs)), now);
  }
  return WarnIfDue(signs, now);
}

}  // namespace limpet
