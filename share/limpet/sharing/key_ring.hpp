// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/core/units.hpp"
#include "limpet/sharing/secure_channel.hpp"
#include "limpet/sharing/share_memory.hpp"

namespace limpet {

/// What seals and opens under one key.
struct KeyedChannel {
  std::shared_ptr<Sealer> sealer;
  std::shared_ptr<Opener> opener;
};

/// The keys of one app, one channel for each: two files with the same key share theirs. What must
/// outlive a restart is kept beside the key, in `<key file>.<sender>.seen`.
class KeyRing {
 public:
  /// Relative files start in `folder`; `unix_time` is when the app starts.
  KeyRing(std::filesystem::path folder, std::string sender_name, Seconds unix_time)
      : folder_(std::move(folder)), sender_name_(std::move(sender_name)), started_(unix_time) {}

  [[nodiscard]] Expected<KeyedChannel> Load(const std::string& file);
  /// Writes down what has changed since the last call; why not, if it cannot.
  [[nodiscard]] std::optional<Error> Save();

 private:
  struct Entry {
    ShareKey key;
    KeyedChannel channel;
    std::filesystem::path memory_file;
    ShareMemory saved;
  };
  [[nodiscard]] Entry MakeEntry(const ShareKey& key, const std::filesystem::path& file) const;

  std::filesystem::path folder_;
  std::string sender_name_;
  Seconds started_;
  std::map<std::string, KeyedChannel> by_file_;
  std::vector<Entry> entries_;
};

}  // namespace limpet
