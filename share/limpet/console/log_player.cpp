// SPDX-License-Identifier: MIT
#include "limpet/console/log_player.hpp"

#include <algorithm>
#include <functional>

#include "limpet/core/require.hpp"
#include "limpet/pubsub/wildcard_list.hpp"

namespace limpet {
bool PlayChoice::AcceptsName(std::string_view name) const {
  const bool is_chosen = only.empty() ? !name.starts_with("DB_") : MatchesAny(only, name);
  return is_chosen && !MatchesAny(skip, name);
}

bool PlayChoice::Accepts(const AlogEntry& entry) const {
  return (!from || entry.time >= *from) && (!to || entry.time <= *to) && AcceptsName(entry.name);
}

LogOutline LogOutline::Of(AlogReader& reader, const PlayChoice& choice) {
  LogOutline outline;
  std::uint64_t order = 0;
  for (AlogEntry entry; reader.Next(entry); ++order) {
    if (!entry.number && !ParseBlogMarker(entry.value) && !outline.texts.contains(entry.name)) {
      outline.texts.emplace(entry.name);
    }
    if (choice.begins_with_held && choice.from && entry.time < *choice.from &&
        choice.AcceptsName(entry.name)) {
      outline.held.insert_or_assign(std::string(entry.name),
                                    HeldEntry{.order = order,
                                              .source = std::string(entry.source),
                                              .aux = std::string(entry.aux),
                                              .value = std::string(entry.value),
                                              .number = entry.number});
    }
    if (!choice.Accepts(entry)) {
      continue;
    }
    if (outline.entries++ == 0) {
      // What the logger found already written can be much older than the log.
      outline.start = choice.from.value_or(std::max(0.0, entry.time));
      outline.end = outline.start;
    }
    outline.end = std::max(outline.end, entry.time);
  }
  return outline;
}

LogPlayer::LogPlayer(AlogReader reader, PlayChoice choice, LogOutline outline,
                     std::filesystem::path folder)
    : reader_(std::move(reader)),
      choice_(std::move(choice)),
      outline_(std::move(outline)),
      folder_(std::move(folder)) {
  for (const auto& [name, entry] : outline_.held) {
    held_.push_back(name);
  }
  std::ranges::sort(held_, std::greater(), [this](const std::string& name) {
    return outline_.held.find(name)->second.order;
  });
  Advance();
}

void LogPlayer::Advance() {
  AlogEntry entry;
  entry_.reset();
  while (reader_.Next(entry)) {
    if (choice_.Accepts(entry)) {
      entry_ = entry;
      due_ = std::max(due_, entry.time - outline_.start);
      return;
    }
  }
}

std::optional<Message> LogPlayer::NextHeld() {
  const auto& [name, held] = *outline_.held.find(held_.back());
  std::optional<Message> message = MessageOf({.name = name,
                                              .source = held.source,
                                              .aux = held.aux,
                                              .value = held.value,
                                              .number = held.number});
  held_.pop_back();
  return message;
}

std::optional<Message> LogPlayer::Next(double elapsed) {
  std::optional<Message> message;
  while (!message && !held_.empty()) {
    message = NextHeld();
    (message ? played_ : unreadable_) += 1;
  }
  while (!message && entry_ && due_ <= elapsed) {
    message = MessageOf(*entry_);
    (message ? played_ : unreadable_) += 1;
    Advance();
  }
  return message;
}

std::optional<Message> LogPlayer::MessageOf(const AlogEntry& entry) const {
  Message message{.name = std::string(entry.name),
                  .value = std::string(entry.value),
                  .time = Seconds(0.0),
                  .source = std::string(entry.source),
                  .source_aux = std::string(entry.aux),
                  .community = ""};
  if (const std::optional<BlogSpan> span = ParseBlogMarker(entry.value)) {
    Expected<Binary> bytes = ReadBlog(folder_, *span);
    if (!bytes) {
      return std::nullopt;
    }
    message.value = *std::move(bytes);
  } else if (entry.number && !outline_.texts.contains(entry.name)) {
    message.value = *entry.number;
  }
  return message;
}

}  // namespace limpet
