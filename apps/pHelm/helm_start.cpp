// SPDX-License-Identifier: MIT
// What the helm says of itself: as it starts, or starts again, and how busy it is.
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "apps/pHelm/behavior_loading.hpp"
#include "apps/pHelm/helm_app.hpp"
#include "apps/pHelm/helm_warnings.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {

void HelmApp::Introduce() {
  if (std::exchange(is_introduced_, true)) return;
  journal_.PostStart(host_, now());
  journal_.PostLifeEvents(host_.TakeLifeEvents(), 1, now());
  if (!params_.helm_alias.empty() && !lead_.leads()) {
    Publish(topics::kHelmAlias, params_.helm_alias);
  }
  if (context().runs_live) {  // embedded, no logger keeps copies
    for (const std::string& file : params_.behaviors) {
      Publish(topics::kLoggerCommand, "COPY_FILE_REQUEST = " + file);
    }
  }
  if (context().is_restarted) return;  // DEPLOY = false would end a mission under way
  PostInitial(BehaviorHost::Initials::kAll);
  if (app_wait_.is_over()) return;
  SubscribeRaw("DB_CLIENTS", [this](const MessagePtr& message) {
    if (const auto* clients = std::get_if<std::string>(&message->value)) app_wait_.Hear(*clients);
  });
}

void HelmApp::PostInitial(BehaviorHost::Initials which) {
  std::vector<HelmPost> posts = host_.InitialPosts(which);
  const auto requests = std::stable_partition(
      posts.begin(), posts.end(), [](const HelmPost& post) { return post.aux == "HELM_VAR_INIT"; });
  requests_.assign(std::make_move_iterator(requests), std::make_move_iterator(posts.end()));
  posts.erase(requests, posts.end());
  Post(posts);
}

void HelmApp::TellRestart() {
  if (!std::exchange(is_restart_untold_, false) || lead_.leads()) return;
  Publish(topics::kHelmRestarted, std::string("true"));
}

void HelmApp::OnRestart(const Message& message) {
  // A database tells whoever begins to listen the last value once more. Clocks may differ a little.
  constexpr Seconds kStale(5.0);
  const auto* type = std::get_if<std::string>(&message.value);
  if (message.time < made_at_ - kStale) return;
  if (type == nullptr || (*type != "type1" && *type != "type2")) {
    Warn(warnings::kRestartRefused, "type1 or type2 is to be said, by " + message.source);
    return;
  }
  using Initials = BehaviorHost::Initials;
  BeginAnew(*type == "type2" ? Initials::kAll : Initials::kDeferred);
}

void HelmApp::BeginAnew(BehaviorHost::Initials posted) {
  try {
    BehaviorHost fresh(LoadBehaviorFiles(context(), params_), ClockOf(context()));
    Post(host_.Retire(StateAt(now())));
    std::ranges::move(host_.TakeFailures(), std::back_inserter(call_failures_));
    std::ranges::move(host_.TakeLateCalls(), std::back_inserter(call_late_));
    fresh.TakeHeard(host_);
    host_ = std::move(fresh);
  } catch (const ConfigError& error) {
    Warn(warnings::kRestartRefused, error.what());
    return;
  }
  ClearWarning(warnings::kRestartRefused);
  ReportEvent(events::kHelmBeganAnew, fmt::format("{} behaviors", host_.statuses().size()));
  planner_.DropPath();
  bids_.reset();
  view_failures_.clear();
  view_late_.clear();
  SubscribeForBehaviors();
  if (!is_introduced_) return;  // it begins with these
  journal_.PostStart(host_, now());
  journal_.PostLifeEvents(host_.TakeLifeEvents(), helm_iteration_, now());
  PostInitial(posted);
  is_restart_untold_ = true;
}

void HelmApp::TellLoad() {
  constexpr Seconds kPeriod(1.0);
  const Seconds now = SteadyTime();
  if (now - told_use_at_ < kPeriod) return;
  const ProcessUse use = UseOfThisProcess();
  if (told_use_at_ > Seconds(0.0)) {
    Publish(topics::kHelmCpu, 100.0 * ((use.cpu - told_use_.cpu) / (now - told_use_at_)));
  }
  told_use_ = use;
  told_use_at_ = now;
}

}  // namespace limpet
