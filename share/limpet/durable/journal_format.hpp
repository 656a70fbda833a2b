// SPDX-License-Identifier: MIT
// A journal's bytes: a header of 8, then records, each its size (4 bytes, little-endian), a
// checksum (8) and the payload. The checksum covers the one before it, too, so that what an earlier
// life left behind the end never counts as a record. The first record that is not whole ends the
// journal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>

namespace limpet {

inline constexpr std::string_view kJournalHeader{"LJOURN1\n"};
inline constexpr std::size_t kJournalRecordHead = 12;  ///< bytes before a payload

/// Appends the record of a payload to `out`. `chain`: the checksum of the record before it, 0 for
/// the first; then its own.
void AppendJournalRecord(std::string& out, std::uint64_t& chain, std::string_view payload);

/// Reads the records of a journal, whatever its bytes are.
class JournalReader {
 public:
  /// `in` outlives it and is at its beginning; `size`: its bytes.
  JournalReader(std::istream& in, std::uint64_t size);
  /// The next payload; false behind the last whole record.
  [[nodiscard]] bool Next(std::string& payload);
  /// Where the last record given ends: there the journal goes on. 0: it has no header.
  [[nodiscard]] std::uint64_t end() const { return end_; }
  /// Checksum of the last record given.
  [[nodiscard]] std::uint64_t chain() const { return chain_; }

 private:
  [[nodiscard]] bool Read(char* out, std::uint64_t count);

  std::istream& in_;
  std::uint64_t size_;
  std::uint64_t end_ = 0, chain_ = 0;
};

}  // namespace limpet
