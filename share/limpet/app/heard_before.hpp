// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>

#include "limpet/core/message.hpp"

namespace limpet {

/// Tells, after a lost connection, news from latest values that were heard before it was lost: a
/// broker sends every latest value to a client that registers anew. What an app has worked off must
/// not reach it twice, and a sample of before must not come after one of now. Not thread-safe.
class HeardBefore {
 public:
  /// Mail that follows belongs to a new connection.
  void StartConnection() { ++connection_; }
  /// Heard in a former life, before any connection of this one.
  void NoteFormer(const Message& message);
  /// The variable's latest value has been asked for: the next one is news.
  void Forget(const std::string& name) { last_.erase(name); }
  /// Notes a message. False if it is a latest value no newer than what the same writer was heard to
  /// say on a former connection.
  [[nodiscard]] bool IsNews(const Message& message);

 private:
  struct Last {
    Seconds time;
    std::string source;
    std::uint64_t connection = 0;
  };
  std::uint64_t connection_ = 1;
  std::unordered_map<std::string, Last> last_;
};

}  // namespace limpet
