// SPDX-License-Identifier: MIT
#include "limpet/app/heard_before.hpp"

#include "limpet/wire/message_id.hpp"

namespace limpet {

bool HeardBefore::IsNews(const Message& message) {
  const auto [position, is_first] = last_.try_emplace(message.name);
  Last& last = position->second;
  if (!is_first && message.id == message_id::kLatest && last.connection != connection_ &&
      last.source == message.source && message.time <= last.time) {
    return false;
  }
  last.time = message.time;
  last.connection = connection_;
  if (last.source != message.source) {
    last.source = message.source;
  }
  return true;
}

void HeardBefore::NoteFormer(const Message& message) {
  last_[message.name] = {.time = message.time, .source = message.source, .connection = 0};
}

}  // namespace limpet
