// SPDX-License-Identifier: MIT
// Any bytes as the mail of a former life: what is read is what was whole, and the journal goes on
// behind it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include <sys/mman.h>
#include <unistd.h>

#include "limpet/app/mail_journal.hpp"

using namespace limpet;  // NOLINT(google-build-using-namespace): one function

namespace {

std::size_t EntriesIn(const MailJournal& journal) {
  std::size_t count = 0;
  journal.Replay([&count](Seconds, const MessagePtr&) { ++count; });
  return count;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const int file = ::memfd_create("fuzz", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  if (::ftruncate(file, 0) != 0 || ::pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) {
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
