// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <system_error>

#include "limpet/durable/append_file.hpp"
#include "limpet/logbook/log_losses.hpp"

namespace limpet {

/// A log's end: lines that wait to be handed over, and an account of those that a disk did not
/// take. While it takes nothing up to 4 MiB wait for room; beyond that they are dropped, and the
/// log says how many, where they would be.
class LogBuffer {
 public:
  static constexpr std::size_t kMostBytesKept = std::size_t{4} << 20U;
  explicit LogBuffer(AppendFile file) : file_(std::move(file)) {}

  /// Appended to at will; whole lines.
  [[nodiscard]] std::string& text() { return text_; }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] AppendFile& file() { return file_; }
  /// A message or row was appended to the text.
  void NoteEntry() { ++losses_.waiting; }
  /// One could not even be appended.
  void NoteDropped();

  /// Writes to the system. False while the disk does not take it.
  bool Flush();
  /// Writes to the disk. False while it does not take it.
  bool Sync();
  /// Why the last of these said false.
  [[nodiscard]] std::error_code trouble() const { return trouble_; }
  [[nodiscard]] const LogLosses& losses() const { return losses_; }

 private:
  [[nodiscard]] bool HandOver();

  AppendFile file_;
  std::string text_;
  LogLosses losses_;
  std::uint64_t unsynced_ = 0;  ///< entries with the system alone
  std::uint64_t unsaid_ = 0;    ///< dropped ones that the log does not tell of yet
  std::error_code trouble_;
};

}  // namespace limpet
