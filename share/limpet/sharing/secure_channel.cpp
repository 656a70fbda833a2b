// SPDX-License-Identifier: MIT
#include "limpet/sharing/secure_channel.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include <sodium.h>

#include "limpet/sharing/sodium_start.hpp"
#include "limpet/wire/little_endian.hpp"

namespace limpet {
namespace {

constexpr std::array<std::byte, 4> kMagic{std::byte{'L'}, std::byte{'S'}, std::byte{'H'},
                                          std::byte{'1'}};
constexpr std::size_t kNonceSize = crypto_aead_xchacha20poly1305_ietf_NPUBBYTES;
constexpr std::size_t kTagSize = crypto_aead_xchacha20poly1305_ietf_ABYTES;
constexpr std::size_t kHeaderSize = kMagic.size() + kNonceSize;
static_assert(kNonceSize == 3 * sizeof(std::uint64_t));
static_assert(kHeaderSize + kTagSize == kSealSize);
static_assert(kShareKeySize == crypto_aead_xchacha20poly1305_ietf_KEYBYTES);

constexpr int kRandomBits = 20;

const unsigned char* Raw(const std::byte* bytes) {
  return reinterpret_cast<const unsigned char*>(bytes);
}
unsigned char* Raw(std::byte* bytes) { return reinterpret_cast<unsigned char*>(bytes); }

}  // namespace

std::uint64_t ShareSenderId(std::string_view name) {
  StartSodium();
  std::array<std::byte, crypto_generichash_BYTES> digest{};
  crypto_generichash(Raw(digest.data()), digest.size(),
                     reinterpret_cast<const unsigned char*>(name.data()), name.size(), nullptr, 0);
  return Get<std::uint64_t>(digest.data());
}

std::uint64_t NewShareEpoch(Seconds unix_time, std::uint64_t former) {
  StartSodium();
  const auto milliseconds = static_cast<std::uint64_t>(std::max(unix_time.value(), 0.0) * 1e3);
  const std::uint64_t drawn = randombytes_uniform(1U << kRandomBits);
  const std::uint64_t by_clock = milliseconds << kRandomBits | drawn;
  // Behind a clock that went back, on from the former epoch.
  return by_clock > former ? by_clock : ((former >> kRandomBits) + 1) << kRandomBits | drawn;
}

Sealer::Sealer(ShareKey key, std::uint64_t sender, std::uint64_t epoch)
    : key_(std::move(key)), sender_(sender), epoch_(epoch) {
  StartSodium();
}

ByteBuffer Sealer::Seal(ByteView plain) {
  ByteBuffer sealed(plain.size() + kSealSize);
  std::byte* out = std::ranges::copy(kMagic, sealed.data()).out;
  const std::byte* nonce = out;
  out = Put(out, sender_);
  out = Put(out, epoch_);
  out = Put(out, counter_++);
  unsigned long long size = 0;
  crypto_aead_xchacha20poly1305_ietf_encrypt(Raw(out), &size, Raw(plain.data()), plain.size(),
                                             Raw(sealed.data()), kMagic.size(), nullptr, Raw(nonce),
                                             key_.bytes().data());
  return sealed;
}

Opener::Opener(ShareKey key, std::uint64_t own_sender)
    : key_(std::move(key)), own_sender_(own_sender) {
  StartSodium();
}

bool LooksSealed(ByteView datagram) {
  return datagram.size() >= kMagic.size() &&
         std::ranges::equal(datagram.first(kMagic.size()), kMagic);
}

Expected<ByteBuffer, ShareRefusal> Opener::Open(ByteView datagram) {
  if (!LooksSealed(datagram)) {
    return ShareRefusal::kNotSealed;
  }
  if (datagram.size() < kSealSize) {
    return ShareRefusal::kMalformed;
  }
  const std::byte* nonce = datagram.data() + kMagic.size();
  ByteBuffer plain(datagram.size() - kSealSize);
  unsigned long long size = 0;
  const ByteView body = datagram.subspan(kHeaderSize);
  if (crypto_aead_xchacha20poly1305_ietf_decrypt(
          Raw(plain.data()), &size, nullptr, Raw(body.data()), body.size(), Raw(datagram.data()),
          kMagic.size(), Raw(nonce), key_.bytes().data()) != 0) {
    return ShareRefusal::kForged;
  }
  // Only now is anything in it worth believing.
  const auto sender = Get<std::uint64_t>(nonce);
  const auto epoch = Get<std::uint64_t>(nonce + sizeof(std::uint64_t));
  const auto counter = Get<std::uint64_t>(nonce + 2 * sizeof(std::uint64_t));
  if (sender == own_sender_) {
    return ShareRefusal::kOwn;
  }
  if (!windows_.contains(sender) && windows_.size() >= kMostSenders) {
    return ShareRefusal::kOverflow;
  }
  ReplayWindow& window = windows_[sender];
  using Verdict = ReplayWindow::Verdict;
  const Verdict verdict = window.Judge(epoch, counter);
  if (verdict != Verdict::kNew) {
    return verdict == Verdict::kFormerEpoch ? ShareRefusal::kFormer : ShareRefusal::kReplayed;
  }
  window.Take(epoch, counter);
  return plain;
}

void Opener::Remember(std::uint64_t sender, std::uint64_t epoch, std::uint64_t counter) {
  if (windows_.size() < kMostSenders) {
    windows_[sender].Forget(epoch, counter);
  }
}

}  // namespace limpet
