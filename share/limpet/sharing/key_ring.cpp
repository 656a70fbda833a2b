// SPDX-License-Identifier: MIT
#include "limpet/sharing/key_ring.hpp"

#include <algorithm>
#include <cctype>

namespace limpet {
namespace {

/// `<key file>.<sender>.seen`, with what a file's name should not have left out.
std::filesystem::path MemoryFile(const std::filesystem::path& key_file, std::string sender) {
  std::ranges::replace_if(
      sender, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
  return key_file.string() + "." + sender + ".seen";
}

ShareMemory MemoryOf(const KeyedChannel& channel) {
  ShareMemory memory{.own_epoch = channel.sealer->epoch(), .heard = {}};
  for (const auto& [sender, window] : channel.opener->windows()) {
    if (window.top()) {
      memory.heard[sender] = {.epoch = window.epoch(), .counter = *window.top()};
    }
  }
  return memory;
}

}  // namespace

KeyRing::Entry KeyRing::MakeEntry(const ShareKey& key, const std::filesystem::path& file) const {
  const std::uint64_t sender = ShareSenderId(sender_name_);
  const std::filesystem::path memory_file = MemoryFile(file, sender_name_);
  const ShareMemory memory = ShareMemory::Load(memory_file);
  auto opener = std::make_shared<Opener>(key, sender);
  for (const auto& [other, heard] : memory.heard) {
    opener->Remember(other, heard.epoch, heard.counter);
  }
  auto sealer = std::make_shared<Sealer>(key, sender, NewShareEpoch(started_, memory.own_epoch));
  return {.key = key,
          .channel = {.sealer = std::move(sealer), .opener = std::move(opener)},
          .memory_file = memory_file,
          .saved = {}};
}

Expected<KeyedChannel> KeyRing::Load(const std::string& file) {
  if (const auto known = by_file_.find(file); known != by_file_.end()) {
    return known->second;
  }
  const std::filesystem::path path = folder_ / file;
  const auto key = LoadShareKey(path);
  if (!key) {
    return key.error();
  }
  auto entry = std::ranges::find_if(
      entries_, [&key](const Entry& known) { return known.key.bytes() == key->bytes(); });
  if (entry == entries_.end()) {
    entries_.push_back(MakeEntry(*key, path));
    entry = std::prev(entries_.end());
  }
  return by_file_.emplace(file, entry->channel).first->second;
}

std::optional<Error> KeyRing::Save() {
  std::optional<Error> first;
  for (Entry& entry : entries_) {
    const ShareMemory memory = MemoryOf(entry.channel);
    if (memory == entry.saved) {
      continue;
    }
    entry.saved = memory;
    const auto error = entry.saved.Save(entry.memory_file);
    first = first ? first : error;
  }
  return first;
}

}  // namespace limpet
