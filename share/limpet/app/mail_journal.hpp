// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <system_error>

#include "limpet/core/message.hpp"
#include "limpet/durable/append_thread.hpp"

namespace limpet {

/// What an app has heard and when it ticked, in a file. An app is a function of its mail: one that
/// was killed goes through the journal of its former life and is where it was. A cut end is left
/// off. A thread of its own writes it, so that the app never waits for a disk: a killed process
/// loses milliseconds of it, a power cut less than a second. An app that died of its journal twice
/// is spared it. Not thread-safe.
class MailJournal {
 public:
  static constexpr std::uint64_t kLargest = std::uint64_t{512} << 20;  ///< bytes; then it ends

  /// Continues the file if `continues`, else begins it anew. REQUIRES: the folder exists.
  MailJournal(std::filesystem::path file, bool continues, FileSystem& disk = RealFileSystem());
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
  /// Hands what was noted to the thread.
  void Flush();
  /// Removes the file, at an orderly end: nobody is to go on from here.
  void Remove();
  /// Entries are taken and found again.
  [[nodiscard]] bool is_good() const { return trouble_.empty(); }
  /// Why they are no longer; for a person.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

 private:
  /// What is found of the former life.
  struct Former {
    std::uint64_t end = 0;    ///< of its last whole entry; 0: none that can be gone on with
    std::uint64_t chain = 0;  ///< checksum of that entry
    int attempts = 0;         ///< to go through it, in vain
  };
  [[nodiscard]] Former ReadFormer() const;
  [[nodiscard]] Expected<AppendFile> Open(const Former& former);
  void Append(char kind, Seconds now, std::string_view bytes);

  std::filesystem::path file_;
  FileSystem& disk_;
  std::unique_ptr<AppendThread> thread_;
  std::uint64_t former_end_ = 0;  ///< of the former life's entries
  std::uint64_t end_ = 0;         ///< of all that was noted
  std::uint64_t chain_ = 0;
  std::string pending_;
  std::string trouble_;
};

}  // namespace limpet
