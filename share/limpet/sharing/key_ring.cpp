// SPDX-License-Identifier: MIT
#include "limpet/sharing/key_ring.hpp"

#include <algorithm>

namespace limpet {

Expected<KeyedChannel> KeyRing::Load(const std::string& file) {
  if (const auto known = by_file_.find(file); known != by_file_.end()) {
    return known->second;
  }
  const auto key = LoadShareKey(folder_ / file);
  if (!key) {
    return key.error();
  }
  return by_file_.emplace(file, ChannelOf(*key)).first->second;
}

KeyedChannel& KeyRing::ChannelOf(const ShareKey& key) {
  const auto known = std::ranges::find_if(
      channels_, [&key](const Entry& entry) { return entry.key.bytes() == key.bytes(); });
  if (known != channels_.end()) {
    return known->channel;
  }
  channels_.push_back({key,
                       {.sealer = std::make_shared<Sealer>(key, sender_, epoch_),
                        .opener = std::make_shared<Opener>(key, sender_)}});
  return channels_.back().channel;
}

}  // namespace limpet
