// SPDX-License-Identifier: MIT
#include "limpet/app/mail_journal.hpp"

#include <fstream>
#include <optional>
#include <utility>

#include "limpet/durable/journal_format.hpp"
#include "limpet/wire/little_endian.hpp"
#include "limpet/wire/message_codec.hpp"
#include "limpet/wire/message_conversion.hpp"

namespace limpet {
namespace {

constexpr int kMostAttempts = 2;
constexpr std::size_t kEntryHead = 9;  // kind, time
constexpr std::size_t kPendingLimit = std::size_t{256} << 10;
constexpr char kMail = 'M', kTick = 'T';
constexpr char kAttempt = 'A';  // a new life begins to go through what is before
constexpr char kVouched = 'V';  // it has, and lives

struct Entry {
  char kind = kTick;
  Seconds now;
  ByteView mail;  ///< in the payload
};

/// Nothing if it is none.
std::optional<Entry> EntryIn(const std::string& payload) {
  if (payload.size() < kEntryHead) {
    return std::nullopt;
  }
  const auto* bytes = reinterpret_cast<const std::byte*>(payload.data());
  const Entry entry{.kind = payload.front(),
                    .now = Seconds(Get<double>(bytes + 1)),
                    .mail = {bytes + kEntryHead, payload.size() - kEntryHead}};
  const bool is_known = entry.kind == kTick || entry.kind == kAttempt || entry.kind == kVouched ||
                        (entry.kind == kMail && DecodeMessage(entry.mail).has_value());
  return is_known ? std::optional(entry) : std::nullopt;
}

std::uint64_t FileSizeOf(const std::filesystem::path& file) {
  std::error_code missing;
  const std::uintmax_t size = std::filesystem::file_size(file, missing);
  return missing ? 0 : size;
}

}  // namespace

MailJournal::MailJournal(std::filesystem::path file, bool continues, FileSystem& disk)
    : file_(std::move(file)), disk_(disk) {
  Former former = continues ? ReadFormer() : Former{};
  if (former.attempts >= kMostAttempts) {
    former = {};
  }
  former_end_ = former.end;
  Expected<AppendFile> opened = Open(former);
  if (opened) {
    thread_ = std::make_unique<AppendThread>(*std::move(opened));
  } else {
    trouble_ = opened.error().text;
  }
}

MailJournal::~MailJournal() { Flush(); }

MailJournal::Former MailJournal::ReadFormer() const {
  Former former;
  std::ifstream in(file_, std::ios::binary);
  JournalReader reader(in, FileSizeOf(file_));
  former.end = reader.end();
  for (std::string payload; reader.Next(payload);) {
    const std::optional<Entry> entry = EntryIn(payload);
    if (!entry) {
      break;
    }
    former.attempts = entry->kind == kVouched   ? 0
                      : entry->kind == kAttempt ? former.attempts + 1
                                                : former.attempts;
    former.end = reader.end();
    former.chain = reader.chain();
  }
  return former;
}

/// What must be with the system before the app goes through its former life is written at once.
Expected<AppendFile> MailJournal::Open(const Former& former) {
  Expected<AppendFile> file = former.end == 0 ? AppendFile::Create(file_, disk_)
                                              : AppendFile::ContinueAt(file_, former.end, disk_);
  end_ = former.end;
  chain_ = former.chain;
  if (former.end == 0) {
    pending_ = kJournalHeader;
  } else {
    Append(kAttempt, Seconds(0.0), {});
  }
  if (file && !file->Append(pending_)) {
    return Error{file->trouble().message()};
  }
  end_ += std::exchange(pending_, {}).size();
  return file;
}

void MailJournal::Replay(
    const std::function<void(Seconds now, const MessagePtr& mail)>& take) const {
  if (!is_good() || former_end_ == 0) {
    return;
  }
  std::ifstream in(file_, std::ios::binary);
  JournalReader reader(in, former_end_);
  for (std::string payload; reader.Next(payload);) {
    const std::optional<Entry> entry = EntryIn(payload);
    if (!entry || entry->kind == kAttempt || entry->kind == kVouched) {
      continue;
    }
    MessagePtr mail;
    if (entry->kind == kMail) {
      mail = std::make_shared<const Message>(MessageFrom(DecodeMessage(entry->mail)->message));
    }
    take(entry->now, mail);
  }
}

void MailJournal::Vouch() {
  if (former_end_ == 0) {
    return;
  }
  Append(kVouched, Seconds(0.0), {});
  Flush();
}

void MailJournal::Append(char kind, Seconds now, std::string_view bytes) {
  std::string payload(kEntryHead, kind);
  Put(reinterpret_cast<std::byte*>(payload.data()) + 1, now.value());
  payload += bytes;
  AppendJournalRecord(pending_, chain_, payload);
  if (pending_.size() >= kPendingLimit) {
    Flush();
  }
}

void MailJournal::NoteMail(const Message& message, Seconds now) {
  const WireMessage view = ViewOf(message);
  std::string bytes(EncodedSize(view), '\0');
  EncodeMessage(view, reinterpret_cast<std::byte*>(bytes.data()));
  Append(kMail, now, bytes);
}

void MailJournal::NoteTick(Seconds now) { Append(kTick, now, {}); }

void MailJournal::Flush() {
  if (thread_ && is_good() && !pending_.empty()) {
    end_ += pending_.size();
    if (end_ > kLargest) {
      thread_->GiveUp(std::make_error_code(std::errc::file_too_large));
    } else {
      thread_->Put(pending_);
    }
    if (const std::error_code trouble = thread_->trouble()) {
      trouble_ = trouble.message();
    }
  }
  pending_.clear();
}

void MailJournal::Remove() {
  thread_.reset();
  static_cast<void>(disk_.Remove(file_));
}

}  // namespace limpet
