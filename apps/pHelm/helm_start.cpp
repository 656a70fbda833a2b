// SPDX-License-Identifier: MIT
// What the helm says of itself: as it starts, or starts again, and how busy it is.
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "apps/pHelm/helm_app.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {

void HelmApp::PostInitialValues() {
  if (std::exchange(has_posted_initial_, true)) return;
  journal_.PostStart(host_, now());
  journal_.PostLifeEvents(host_.TakeLifeEvents(), 1, now());
  if (context().runs_live) {  // embedded, no logger keeps copies
    for (const std::string& file : params_.behaviors) {
      Publish(topics::kLoggerCommand, "COPY_FILE_REQUEST = " + file);
    }
  }
  if (context().is_restarted) return;  // DEPLOY = false would end a mission under way
  std::vector<HelmPost> posts = host_.InitialPosts();
  const auto requests = std::stable_partition(
      posts.begin(), posts.end(), [](const HelmPost& post) { return post.aux == "HELM_VAR_INIT"; });
  requests_.assign(std::make_move_iterator(requests), std::make_move_iterator(posts.end()));
  posts.erase(requests, posts.end());
  Post(posts);
  if (app_wait_.is_over()) return;
  SubscribeRaw("DB_CLIENTS", [this](const MessagePtr& message) {
    if (const auto* clients = std::get_if<std::string>(&message->value)) app_wait_.Hear(*clients);
  });
}

void HelmApp::TellRestart() {
  if (!context().is_restarted || is_restart_told_) return;
  is_restart_told_ = true;
  if (!lead_.leads()) Publish(topics::kHelmRestarted, std::string("true"));
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
