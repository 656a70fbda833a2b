// SPDX-License-Identifier: MIT
#include "limpet/sharing/key_ring.hpp"

#include <algorithm>

namespace limpet {

Expected<KeyedChannel> KeyRing::Load(const std::string& file, ShareInstant now) {
  if (const auto known = by_file_.find(file); known != by_file_.end()) {
    return known->second;
  }
  const auto key = LoadShareKey(folder_ / file);
  if (!key) {
    return key.error();
  }
  auto entry = std::ranges::find_if(
      entries_, [&key](const Entry& known) { return known.key.bytes() == key->bytes(); });
  if (entry == entries_.end()) {
    auto sealer = std::make_shared<Sealer>(*key, now);
    auto guard = std::make_shared<ShareGuard>(*key, settings_, sealer, now);
    entries_.push_back(
        {.key = *key, .channel = {.sealer = std::move(sealer), .guard = std::move(guard)}});
    entry = std::prev(entries_.end());
  }
  return by_file_.emplace(file, entry->channel).first->second;
}

std::optional<ByteBuffer> KeyRing::Answer(ByteView datagram, ShareInstant now) {
  for (const Entry& entry : entries_) {
    if (auto answer = entry.channel.guard->Answer(datagram, now)) {
      return answer;
    }
  }
  return std::nullopt;
}

std::size_t KeyRing::TakeGivenUp(ShareInstant now) {
  std::size_t count = 0;
  for (const Entry& entry : entries_) {
    count += entry.channel.guard->TakeGivenUp(now);
  }
  return count;
}

}  // namespace limpet
