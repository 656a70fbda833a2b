// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/sharing/secure_channel.hpp"

namespace limpet {

/// What seals and opens under one key.
struct KeyedChannel {
  std::shared_ptr<Sealer> sealer;
  std::shared_ptr<Opener> opener;
};

/// The keys of one app, one channel for each: two files with the same key share theirs.
class KeyRing {
 public:
  /// Relative files start in `folder`.
  KeyRing(std::filesystem::path folder, std::uint64_t sender, std::uint64_t epoch)
      : folder_(std::move(folder)), sender_(sender), epoch_(epoch) {}

  [[nodiscard]] Expected<KeyedChannel> Load(const std::string& file);

 private:
  struct Entry {
    ShareKey key;
    KeyedChannel channel;
  };
  [[nodiscard]] KeyedChannel& ChannelOf(const ShareKey& key);

  std::filesystem::path folder_;
  std::uint64_t sender_, epoch_;
  std::map<std::string, KeyedChannel> by_file_;
  std::vector<Entry> channels_;
};

}  // namespace limpet
