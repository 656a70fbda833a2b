// SPDX-License-Identifier: MIT
#include "limpet/launch/community_watch.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "limpet/core/clock.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {
namespace {

constexpr std::size_t kMostRequests = 1000;

std::string StatusVariableOf(std::string name) {
  std::ranges::transform(name, name.begin(), [](char c) {
    return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  });
  return name + "_STATUS";
}

/// `...,Subscribing="A,B,"`: true if the list holds `variable`, or `*`.
bool Lists(std::string_view status, std::string_view variable) {
  constexpr std::string_view kBegin = "Subscribing=\"";
  const auto begin = status.find(kBegin);
  if (begin == std::string_view::npos) {
    return false;
  }
  status.remove_prefix(begin + kBegin.size());
  std::string_view list = status.substr(0, status.find('"'));
  while (!list.empty()) {
    const auto comma = std::min(list.find(','), list.size());
    const std::string_view name = list.substr(0, comma);
    if (name == variable || name == "*") {
      return true;
    }
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return false;
}

}  // namespace

CommunityWatch::CommunityWatch(const Settings& settings)
    : until_(settings.until),
      client_({.host = "localhost",
               .port = settings.port,
               .name = "pLaunch",
               .warp = settings.warp,
               .on_mail = [this](const WireMessage& message) { Hear(message); },
               .on_state = nullptr}) {
  for (const std::string& variable :
       {std::string("DB_CLIENTS"), std::string("DB_EVENT"), topics::kAppCastRequest.name,
        topics::kDeploy.name, topics::kMissionEnd.name, topics::kSurveyPhase.name,
        topics::kHelmState.name, topics::kHelmAllStop.name}) {
    client_.Subscribe(variable, Seconds(0.0));
  }
  for (const std::string& variable : {topics::kThrusterCommand.name, topics::kNavDepth.name}) {
    client_.Subscribe(variable, Seconds(0.5));
  }
  client_.SubscribeWildcard({.app_pattern = "*", .variable_pattern = "*_STATUS", .interval = {}});
  if (!until_.empty()) {
    client_.Subscribe(until_, Seconds(0.0));
  }
}

std::optional<CommunityWatch::Heard> CommunityWatch::Latest(const std::string& variable) const {
  const std::lock_guard lock(mutex_);
  const auto found = latest_.find(variable);
  return found == latest_.end() ? std::nullopt : std::optional<Heard>(found->second);
}

std::string CommunityWatch::TextOf(const std::string& variable) const {
  const std::optional<Heard> heard = Latest(variable);
  return heard ? heard->text : "";
}

std::vector<std::string> CommunityWatch::TakeArrivals() {
  const std::lock_guard lock(mutex_);
  return std::exchange(arrivals_, {});
}

std::vector<std::string> CommunityWatch::TakeRequests() {
  const std::lock_guard lock(mutex_);
  return std::exchange(requests_, {});
}

bool CommunityWatch::IsUp(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  return up_.contains(name);
}

std::set<std::string> CommunityWatch::WhoIsUp() const {
  const std::lock_guard lock(mutex_);
  return up_;
}

bool CommunityWatch::Hears(const std::string& name, const std::string& variable) const {
  return Lists(TextOf(StatusVariableOf(name)), variable);
}

void CommunityWatch::ForgetDatabase() {
  const std::lock_guard lock(mutex_);
  up_.clear();
  latest_.erase(topics::kDeploy.name);
}

bool CommunityWatch::has_heard_the_end() const {
  return !until_.empty() && Latest(until_).has_value();
}

void CommunityWatch::Hear(const WireMessage& message) {
  const std::lock_guard lock(mutex_);
  if (message.key == topics::kAppCastRequest.name) {
    if (requests_.size() < kMostRequests) {
      requests_.emplace_back(message.text);
    }
    return;
  }
  if (message.key == "DB_CLIENTS") {
    for (std::string_view rest = message.text; !rest.empty();) {
      const auto comma = std::min(rest.find(','), rest.size());
      Enter(std::string(rest.substr(0, comma)));
      rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
  } else if (message.key == "DB_EVENT" && message.text.starts_with("connected=")) {
    Enter(std::string(message.text.substr(10)));
  } else if (message.key == "DB_EVENT" && message.text.starts_with("disconnected=")) {
    up_.erase(std::string(message.text.substr(13)));
  }
  Heard& heard = latest_[std::string(message.key)];
  heard.text = message.text;
  heard.number = message.number;
  heard.is_number = message.data_type == wire_data::kDouble;
  heard.source = message.source;
  heard.at = SteadyTime();
  ++heard.times;
}

void CommunityWatch::Enter(const std::string& name) {
  if (!name.empty() && up_.insert(name).second) {
    arrivals_.push_back(name);
  }
}

}  // namespace limpet
