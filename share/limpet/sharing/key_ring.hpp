// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/sharing/share_guard.hpp"

namespace limpet {

/// What seals and lets in under one key.
struct KeyedChannel {
  std::shared_ptr<Sealer> sealer;
  std::shared_ptr<ShareGuard> guard;
};

/// The keys of one app, one channel for each: two files with the same key share theirs.
class KeyRing {
 public:
  /// Relative files start in `folder`.
  KeyRing(std::filesystem::path folder, ShareGuard::Settings settings)
      : folder_(std::move(folder)), settings_(settings) {}

  [[nodiscard]] Expected<KeyedChannel> Load(const std::string& file, ShareInstant now);
  /// True if such a file was loaded before.
  [[nodiscard]] bool Has(const std::string& file) const { return by_file_.contains(file); }
  /// What to answer to a datagram that came to where this app sends from, if anything.
  [[nodiscard]] std::optional<ByteBuffer> Answer(ByteView datagram, ShareInstant now);
  /// How many datagrams have waited for an answer in vain.
  [[nodiscard]] std::size_t TakeGivenUp(ShareInstant now);

 private:
  struct Entry {
    ShareKey key;
    KeyedChannel channel;
  };

  std::filesystem::path folder_;
  ShareGuard::Settings settings_;
  std::map<std::string, KeyedChannel> by_file_;
  std::vector<Entry> entries_;
};

}  // namespace limpet
