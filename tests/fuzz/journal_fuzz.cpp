// SPDX-License-Identifier: MIT
// Any bytes as the mail of a former life, or any records: what is read is what was whole, and the
// journal goes on behind it.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include <sys/mman.h>
#include <unistd.h>

#include "limpet/app/mail_journal.hpp"
#include "limpet/durable/journal_format.hpp"

using namespace limpet;  // NOLINT(google-build-using-namespace): one function

namespace {

std::size_t EntriesIn(const MailJournal& journal) {
  std::size_t count = 0;
  journal.Replay([&count](Seconds, const MessagePtr&) { ++count; });
  return count;
}

/// Pieces of the bytes, each as long as its first byte says, as whole records.
std::string Sealed(std::string_view bytes) {
  std::string journal(kJournalHeader);
  std::uint64_t chain = 0;
  while (!bytes.empty()) {
    const std::size_t size =
        std::min<std::size_t>(static_cast<unsigned char>(bytes.front()), bytes.size() - 1);
    AppendJournalRecord(journal, chain, bytes.substr(1, size));
    bytes.remove_prefix(1 + size);
  }
  return journal;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const int file = ::memfd_create("fuzz", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  const std::string_view raw(reinterpret_cast<const char*>(data), size);
  const bool seals = !raw.empty() && (data[0] & 1U) != 0;
  const std::string bytes = seals ? Sealed(raw.substr(1)) : std::string(raw);
  if (::ftruncate(file, 0) != 0 ||
      ::pwrite(file, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    return 0;
  }
  std::size_t before = 0;
  {
    MailJournal journal(path, true);
    before = EntriesIn(journal);
    journal.Vouch();
    journal.NoteTick(Seconds(1.0));
  }
  if (EntriesIn(MailJournal(path, true)) != before + 1) {
    std::abort();
  }
  return 0;
}
