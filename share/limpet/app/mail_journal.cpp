// SPDX-License-Identifier: MIT
#include "limpet/app/mail_journal.hpp"

#include <array>
#include <fstream>

#include <fcntl.h>
#include <unistd.h>

#include "limpet/wire/little_endian.hpp"
#include "limpet/wire/message_codec.hpp"
#include "limpet/wire/message_conversion.hpp"

namespace limpet {
namespace {

constexpr std::uint32_t kMagic = 0x314c4d4a;  // "JML1"
constexpr std::uint32_t kMostAttempts = 2;
constexpr std::size_t kEntryHead = 13;  // size of the payload, kind, time
constexpr std::size_t kPendingLimit = std::size_t{256} << 10;
constexpr char kMail = 'M', kTick = 'T';

bool ReadExactly(std::istream& in, std::span<std::byte> bytes) {
  return static_cast<bool>(
      in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())));
}

struct Entry {
  char kind = kTick;
  Seconds now;
  ByteBuffer payload;
};

/// The next entry, if it ends within the `left` bytes, which shrink by it.
bool ReadEntry(std::istream& in, std::uint64_t& left, Entry& entry) {
  std::array<std::byte, kEntryHead> head{};
  if (left < kEntryHead || !ReadExactly(in, head)) {
    return false;
  }
  const auto size = Get<std::uint32_t>(head.data());
  entry.kind = Get<char>(head.data() + 4);
  entry.now = Seconds(Get<double>(head.data() + 5));
  if (left - kEntryHead < size) {
    return false;
  }
  entry.payload.resize(size);
  left -= kEntryHead + size;
  return ReadExactly(in, entry.payload) &&
         (entry.kind == kTick || (entry.kind == kMail && DecodeMessage(entry.payload).has_value()));
}

}  // namespace

MailJournal::MailJournal(std::filesystem::path file, bool continues)
    : file_(std::move(file)),
      descriptor_(::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  std::array<std::byte, kHeaderSize> header{};
  std::uint32_t attempts = 0;
  std::ifstream former(file_, std::ios::binary);
  if (continues && is_good() && ReadExactly(former, header) &&
      Get<std::uint32_t>(header.data()) == kMagic) {
    attempts = Get<std::uint32_t>(header.data() + 4);
    end_ = attempts < kMostAttempts ? SoundEnd() : 0;
  }
  const bool begins = end_ <= kHeaderSize;
  if (begins) {
    end_ = kHeaderSize;
  }
  if (!is_good() || ::ftruncate(descriptor_, static_cast<off_t>(end_)) != 0 ||
      !WriteHeader(begins ? 0 : attempts + 1)) {
    GiveUp();
  }
}

MailJournal::~MailJournal() {
  Flush();
  GiveUp();
}

void MailJournal::GiveUp() {
  if (is_good()) {
    ::close(descriptor_);
  }
  descriptor_ = -1;
}

bool MailJournal::WriteHeader(std::uint32_t attempts) {
  std::array<std::byte, kHeaderSize> header{};
  Put(Put(header.data(), kMagic), attempts);
  return ::pwrite(descriptor_, header.data(), header.size(), 0) == kHeaderSize;
}

std::uint64_t MailJournal::SoundEnd() const {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(file_, error);
  std::ifstream in(file_, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(kHeaderSize));
  std::uint64_t left = error || size < kHeaderSize ? 0 : size - kHeaderSize;
  std::uint64_t sound = kHeaderSize;
  for (Entry entry; ReadEntry(in, left, entry);) {
    sound = size - left;
  }
  return sound;
}

void MailJournal::Replay(
    const std::function<void(Seconds now, const MessagePtr& mail)>& take) const {
  if (!is_good()) {
    return;
  }
  std::ifstream in(file_, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(kHeaderSize));
  std::uint64_t left = end_ - kHeaderSize;
  for (Entry entry; ReadEntry(in, left, entry);) {
    MessagePtr mail;
    if (entry.kind == kMail) {
      mail = std::make_shared<const Message>(MessageFrom(DecodeMessage(entry.payload)->message));
    }
    take(entry.now, mail);
  }
}

void MailJournal::Vouch() {
  if (is_good() && !WriteHeader(0)) {
    GiveUp();
  }
}

void MailJournal::Begin(char kind, Seconds now, std::size_t payload) {
  const std::size_t at = pending_.size();
  pending_.resize(at + kEntryHead + payload);
  Put(Put(Put(pending_.data() + at, static_cast<std::uint32_t>(payload)), kind), now.value());
}

void MailJournal::NoteMail(const Message& message, Seconds now) {
  const WireMessage view = ViewOf(message);
  const std::size_t size = EncodedSize(view);
  Begin(kMail, now, size);
  EncodeMessage(view, pending_.data() + pending_.size() - size);
  if (pending_.size() >= kPendingLimit) {
    Flush();
  }
}

void MailJournal::NoteTick(Seconds now) { Begin(kTick, now, 0); }

void MailJournal::Flush() {
  std::size_t written = 0;
  while (is_good() && written < pending_.size()) {
    const ssize_t count = ::pwrite(descriptor_, pending_.data() + written,
                                   pending_.size() - written, static_cast<off_t>(end_));
    if (count <= 0 || end_ > kLargest) {
      // Half a journal would be believed: better none.
      static_cast<void>(::ftruncate(descriptor_, 0));
      GiveUp();
      break;
    }
    written += static_cast<std::size_t>(count);
    end_ += static_cast<std::uint64_t>(count);
  }
  pending_.clear();
}

void MailJournal::Remove() {
  GiveUp();
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

}  // namespace limpet
