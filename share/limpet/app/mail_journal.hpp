// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "limpet/core/message.hpp"
#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// What an app has heard and when it ticked, in a file. An app is a function of its mail: one that
/// was killed goes through the journal of its former life and is where it was. A cut end is left
/// off. It survives the process, not a power cut: nothing is brought to the disk. An app that died
/// of its journal twice is spared it. Not thread-safe.
class MailJournal {
 public:
  static constexpr std::uint64_t kLargest = std::uint64_t{512} << 20;  ///< bytes; then it ends

  /// Continues the file if `continues`, else begins it anew. REQUIRES: the folder exists.
  MailJournal(std::filesystem::path file, bool continues);
  ~MailJournal();
  MailJournal(const MailJournal&) = delete;
  MailJournal& operator=(const MailJournal&) = delete;

  /// Calls `take` for each entry of the former life, in order: the time that was, and the mail; a
  /// tick has none. May be called again.
  void Replay(const std::function<void(Seconds now, const MessagePtr& mail)>& take) const;
  /// The app has gone through it and lives.
  void Vouch();

  void NoteMail(const Message& message, Seconds now);
  void NoteTick(Seconds now);
  /// Hands what was noted to the system.
  void Flush();
  /// Removes the file, at an orderly end: nobody is to go on from here.
  void Remove();
  /// Entries are taken and found again.
  [[nodiscard]] bool is_good() const { return descriptor_ >= 0; }

 private:
  static constexpr std::uint64_t kHeaderSize = 8;  ///< magic, and how often it was replayed in vain
  void Begin(char kind, Seconds now, std::size_t payload);
  [[nodiscard]] bool WriteHeader(std::uint32_t attempts);
  /// Where the last whole entry ends.
  [[nodiscard]] std::uint64_t SoundEnd() const;
  void GiveUp();

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t end_ = 0;  ///< of the former life's entries, later of all that was written
  ByteBuffer pending_;
};

}  // namespace limpet
