// SPDX-License-Identifier: MIT
#include "limpet/app/app_caster.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr std::size_t kMostRequests = 64;  ///< keys come from outside
constexpr std::size_t kMostWarnings = 200;
constexpr double kHighestInterval = 10.0;  ///< [s]
constexpr double kMostEvents = 50.0;

double Number(const ConfigBlock& block, const char* key, double otherwise, double most) {
  const ConfigEntry* entry = block.Find(key);
  if (entry == nullptr) {
    return otherwise;
  }
  const std::optional<double> number = ParseNumber(entry->value);
  if (!number || *number < 0.0 || *number > most) {
    throw ConfigError({entry->where, entry->key,
                       fmt::format("`{}` is not allowed; allowed: 0 to {:g}", entry->value, most)});
  }
  return *number;
}

}  // namespace

CastSettings ReadCastSettings(const ConfigBlock& block) {
  CastSettings settings;
  settings.interval =
      Seconds(Number(block, "TERM_REPORT_INTERVAL", settings.interval.value(), kHighestInterval));
  settings.max_events =
      static_cast<std::size_t>(Number(block, "MAX_APPCAST_EVENTS", 8.0, kMostEvents));
  settings.max_run_warnings =
      static_cast<std::size_t>(Number(block, "MAX_APPCAST_RUN_WARNINGS", 10.0, kMostEvents));
  return settings;
}

void AppCaster::AddEvent(Seconds elapsed, std::string_view text) {
  events_.push_back(fmt::format("[{:.2f}]: {}", elapsed.value(), text));
  while (events_.size() > settings_.max_events) {
    events_.pop_front();
  }
}

void AppCaster::AddConfigWarning(std::string text) {
  config_warnings_.push_back(std::move(text));
  has_news_ = true;
}

void AppCaster::RaiseWarning(const WarningId& id, const std::string& text, Seconds elapsed) {
  if (run_warnings_.size() >= kMostWarnings && !run_warnings_.contains(id.name())) {
    return;
  }
  Raised& warning = run_warnings_[id.name()];
  warning.severity = id.severity();
  warning.text = text;
  if (!warning.is_up) {
    warning.is_up = true;
    warning.since = elapsed;
    ++warning.count;
  }
  for (auto& [key, request] : requests_) {
    request.has_been_told = false;
  }
}

void AppCaster::ClearWarning(const WarningId& id) {
  if (const auto found = run_warnings_.find(id.name()); found != run_warnings_.end()) {
    found->second.is_up = false;
    for (auto& [key, request] : requests_) {
      request.has_been_told = false;
    }
  }
}

void AppCaster::OnRequest(std::string_view text, Seconds now) {
  const std::optional<AppCastRequest> request = ParseAppCastRequest(text);
  if (!request || !request->IsFor(settings_.process, settings_.node)) {
    return;
  }
  std::erase_if(requests_, [now](const auto& entry) { return entry.second.until <= now; });
  const auto known = requests_.find(request->key);
  if (known == requests_.end() && requests_.size() >= kMostRequests) {
    return;
  }
  const bool has_been_told = known != requests_.end() && known->second.has_been_told;
  requests_[request->key] = {.until = now + request->duration * settings_.warp,
                             .wants_warnings_only = request->wants_warnings_only,
                             .has_been_told = has_been_told};
}

bool AppCaster::IsWanted(Seconds now) {
  std::erase_if(requests_, [now](const auto& entry) { return entry.second.until <= now; });
  return std::ranges::any_of(requests_, [this](const auto& entry) {
    const Request& request = entry.second;
    return !request.wants_warnings_only || (!request.has_been_told && !run_warnings_.empty());
  });
}

bool AppCaster::IsDue(Seconds now) {
  if (has_news_ && settings_.casts_unasked) {
    return true;
  }
  if (requests_.empty() || !IsWanted(now)) {
    return false;
  }
  return !last_cast_ || now - *last_cast_ >= settings_.interval * settings_.warp;
}

AppCast AppCaster::Cast(std::vector<std::string> body, std::int64_t iteration, Seconds now) {
  has_news_ = false;
  last_cast_ = now;
  for (auto& [key, request] : requests_) {
    request.has_been_told = true;
  }
  AppCast cast{.process = settings_.process,
               .node = settings_.node,
               .iteration = iteration,
               .messages = std::move(body),
               .config_warnings = config_warnings_,
               .events = {events_.begin(), events_.end()}};
  AddStandingWarnings(cast);
  return cast;
}

void AppCaster::AddStandingWarnings(AppCast& cast) const {
  std::vector<std::pair<std::string_view, const Raised*>> standing;
  for (const auto& [id, warning] : run_warnings_) {
    if (warning.is_up) {
      standing.emplace_back(id, &warning);
      cast.run_warning_total += warning.count;
    }
  }
  std::ranges::stable_sort(standing, std::greater{},
                           [](const auto& entry) { return entry.second->severity; });
  standing.resize(std::min(standing.size(), settings_.max_run_warnings));
  for (const auto& [id, warning] : standing) {
    cast.run_warnings.push_back(
        {.text = fmt::format("{} ({} since [{:.2f}]): {}", id, NameOf(warning->severity),
                             warning->since.value(), warning->text),
         .count = warning->count});
  }
}

}  // namespace limpet
