// SPDX-License-Identifier: MIT
#include "limpet/tuning/live_setting.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pwd.h>
#include <unistd.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

using Json = nlohmann::ordered_json;

std::optional<UpdateCount> CountIn(const std::string& field) {
  const std::vector<std::string> parts = Split(field, '/');
  if (parts.size() != 2) return std::nullopt;
  const auto good = ParseInteger(parts[0]), all = ParseInteger(parts[1]);
  if (!good || !all) return std::nullopt;
  return UpdateCount{.good = static_cast<int>(*good), .all = static_cast<int>(*all)};
}

Json JsonOf(const LiveChange& change) {
  return {{"behavior", change.behavior},
          {"key", change.key},
          {"old", change.old_value},
          {"new", change.new_value}};
}

bool IsOf(const LiveChange& change, std::string_view behavior, std::string_view key) {
  return change.behavior == behavior && EqualsIgnoringCase(change.key, key);
}

LiveChange ChangeFrom(const nlohmann::json& json) {
  return {.behavior = json.at("behavior").get<std::string>(),
          .key = json.at("key").get<std::string>(),
          .old_value = json.at("old").get<std::string>(),
          .new_value = json.at("new").get<std::string>()};
}

}  // namespace

std::optional<UpdateCount> UpdateCountIn(std::string_view summary, std::string_view behavior) {
  // `...,active_bhvs=name$since$pwt$pieces$cpu$good/all$1:other$...,running_bhvs=...`
  for (const std::string& field : Split(summary, ',')) {
    const std::size_t equals = field.find('=');
    if (equals == std::string::npos) continue;
    for (const std::string& entry : Split(std::string_view(field).substr(equals + 1), ':')) {
      const std::vector<std::string> parts = Split(entry, '$');
      if (parts.size() < 3 || parts.front() != behavior) continue;
      for (std::size_t i = 2; i < parts.size(); ++i) {
        if (const auto count = CountIn(parts[i])) return count;
      }
    }
  }
  return std::nullopt;
}

std::string UpdateText(const std::string& behavior, const std::string& key,
                       const std::string& value) {
  return fmt::format("name={}#{}={}", behavior, key, value);
}

std::optional<std::string> UpdatedValue(std::string_view mail, std::string_view behavior,
                                        std::string_view key) {
  std::optional<std::string> value;
  for (const std::string& part : Split(mail, '#')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) continue;
    const std::string_view name = Trim(std::string_view(part).substr(0, equals));
    const std::string_view text = Trim(std::string_view(part).substr(equals + 1));
    if (name == "name" && text != behavior) return std::nullopt;
    if (EqualsIgnoringCase(name, key)) value = text;
  }
  return value;
}

std::optional<std::string> LiveEvent::InForce(std::string_view behavior,
                                              std::string_view key) const {
  if (IsOf(change, behavior, key)) return is_applied ? change.new_value : change.old_value;
  const auto newest = std::find_if(undoable.rbegin(), undoable.rend(), [&](const LiveChange& each) {
    return IsOf(each, behavior, key);
  });
  return newest == undoable.rend() ? std::nullopt : std::optional(newest->new_value);
}

void LiveEvent::DropRefusedUndo() {
  undoable.pop_back();
  const auto below = std::find_if(
      undoable.rbegin(), undoable.rend(),
      [this](const LiveChange& each) { return IsOf(each, change.behavior, change.key); });
  if (below != undoable.rend()) below->new_value = change.old_value;
}

bool LiveEvent::WasRefused(std::string_view behavior, std::string_view key,
                           std::string_view value) const {
  return !is_applied && IsOf(change, behavior, key) && change.new_value == value;
}

std::string LiveEvent::Text() const {
  Json json{{"user", user}, {"host", host}, {"undo", is_undo}, {"applied", is_applied}};
  json.update(JsonOf(change));
  json["undoable"] = Json::array();
  for (const LiveChange& each : undoable)
    json["undoable"].push_back(JsonOf(each));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Expected<LiveEvent> LiveEvent::FromText(const std::string& text) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    LiveEvent event{.user = json.at("user").get<std::string>(),
                    .host = json.at("host").get<std::string>(),
                    .is_undo = json.at("undo").get<bool>(),
                    .is_applied = json.at("applied").get<bool>(),
                    .change = ChangeFrom(json)};
    for (const nlohmann::json& each : json.at("undoable")) {
      if (event.undoable.size() == kMostUndoable) break;
      event.undoable.push_back(ChangeFrom(each));
    }
    return event;
  } catch (const nlohmann::json::exception& error) {
    return Error{error.what()};
  }
}

std::string UserName() {
  passwd entry{};
  passwd* user = nullptr;
  std::array<char, 4096> texts{};
  ::getpwuid_r(::geteuid(), &entry, texts.data(), texts.size(), &user);
  return user != nullptr ? user->pw_name : std::to_string(::geteuid());
}

}  // namespace limpet
