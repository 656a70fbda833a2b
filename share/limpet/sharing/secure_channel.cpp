// SPDX-License-Identifier: MIT
#include "limpet/sharing/secure_channel.hpp"

#include <algorithm>
#include <cmath>

#include <sodium.h>

#include "limpet/core/clock.hpp"
#include "limpet/sharing/sodium_start.hpp"
#include "limpet/wire/little_endian.hpp"

namespace limpet {
namespace {

using Magic = std::array<std::byte, 4>;
constexpr Magic kMagic{std::byte{'L'}, std::byte{'S'}, std::byte{'H'}, std::byte{'2'}};
constexpr Magic kOldMagic{std::byte{'L'}, std::byte{'S'}, std::byte{'H'}, std::byte{'1'}};
constexpr std::size_t kNonceSize = crypto_aead_xchacha20poly1305_ietf_NPUBBYTES;
constexpr std::size_t kTagSize = crypto_aead_xchacha20poly1305_ietf_ABYTES;
constexpr std::size_t kOpenSize = kMagic.size() + kNonceSize;
constexpr std::size_t kHeadSize = 1 + 3 * sizeof(std::uint64_t);  ///< encrypted, before the body
static_assert(kNonceSize == sizeof(ShareRun) + sizeof(std::uint64_t));
static_assert(kOpenSize + kHeadSize + kTagSize == kSealSize);
static_assert(kShareKeySize == crypto_aead_xchacha20poly1305_ietf_KEYBYTES);

const unsigned char* Raw(const std::byte* bytes) {
  return reinterpret_cast<const unsigned char*>(bytes);
}
unsigned char* Raw(std::byte* bytes) { return reinterpret_cast<unsigned char*>(bytes); }

bool StartsWith(ByteView datagram, const Magic& magic) {
  return datagram.size() >= magic.size() && std::ranges::equal(datagram.first(magic.size()), magic);
}

std::uint64_t HashOf(std::string_view kind, std::string_view name) {
  StartSodium();
  const std::string text = std::string(kind) + std::string(name);
  std::array<std::byte, crypto_generichash_BYTES> digest{};
  crypto_generichash(Raw(digest.data()), digest.size(),
                     reinterpret_cast<const unsigned char*>(text.data()), text.size(), nullptr, 0);
  return Get<std::uint64_t>(digest.data());
}

std::uint64_t Microseconds(Seconds time) {
  return static_cast<std::uint64_t>(std::llround(std::max(time.value(), 0.0) * 1e6));
}
Seconds SecondsOf(std::uint64_t microseconds) {
  return Seconds(static_cast<double>(microseconds) * 1e-6);
}

}  // namespace

ShareInstant ShareInstant::Now() { return {.steady = SteadyTime(), .unix = UnixTime()}; }

std::string ShareNodeName(std::string_view name) {
  return std::string(name) + (name.find('/') == std::string_view::npos ? "/pShare" : "");
}
std::uint64_t ShareReceiverId(std::string_view name) {
  return HashOf("limpet node ", ShareNodeName(name));
}
std::uint64_t ShareChannelId(std::string_view address) {
  return HashOf("limpet channel ", address);
}

Sealer::Sealer(const ShareKey& key, ShareInstant now) : key_(key), start_(now.steady) {
  StartSodium();
  randombytes_buf(run_.data(), run_.size());
}

ByteBuffer Sealer::Seal(SealedContent::Kind kind, std::uint64_t receiver, ByteView body,
                        ShareInstant now) {
  ByteBuffer sealed(body.size() + kSealSize);
  std::byte* out = std::ranges::copy(kMagic, sealed.data()).out;
  const std::byte* nonce = out;
  out = std::ranges::copy(run_, out).out;
  out = Put(out, counter_++);
  ByteBuffer plain(kHeadSize);
  std::byte* head = Put(plain.data(), static_cast<std::uint8_t>(kind));
  head = Put(head, receiver);
  head = Put(head, Microseconds(now.steady - start_));
  Put(head, Microseconds(now.unix));
  plain.insert(plain.end(), body.begin(), body.end());
  unsigned long long size = 0;
  crypto_aead_xchacha20poly1305_ietf_encrypt(Raw(out), &size, Raw(plain.data()), plain.size(),
                                             Raw(sealed.data()), kMagic.size(), nullptr, Raw(nonce),
                                             key_.bytes().data());
  return sealed;
}

bool LooksSealed(ByteView datagram) {
  return StartsWith(datagram, kMagic) || StartsWith(datagram, kOldMagic);
}

Expected<SealedContent, ShareRefusal> OpenSealed(const ShareKey& key, ByteView datagram) {
  StartSodium();
  if (!StartsWith(datagram, kMagic)) {
    return StartsWith(datagram, kOldMagic) ? ShareRefusal::kOldVersion : ShareRefusal::kNotSealed;
  }
  if (datagram.size() < kSealSize) {
    return ShareRefusal::kMalformed;
  }
  const std::byte* nonce = datagram.data() + kMagic.size();
  ByteBuffer plain(datagram.size() - kOpenSize - kTagSize);
  unsigned long long size = 0;
  const ByteView body = datagram.subspan(kOpenSize);
  if (crypto_aead_xchacha20poly1305_ietf_decrypt(
          Raw(plain.data()), &size, nullptr, Raw(body.data()), body.size(), Raw(datagram.data()),
          kMagic.size(), Raw(nonce), key.bytes().data()) != 0) {
    return ShareRefusal::kForged;
  }
  // Only now is anything in it worth believing.
  SealedContent content;
  std::copy_n(nonce, content.run.size(), content.run.begin());
  content.counter = Get<std::uint64_t>(nonce + content.run.size());
  content.kind = static_cast<SealedContent::Kind>(plain[0]);
  content.receiver = Get<std::uint64_t>(plain.data() + 1);
  content.age_of_run = SecondsOf(Get<std::uint64_t>(plain.data() + 9));
  content.unix = SecondsOf(Get<std::uint64_t>(plain.data() + 17));
  content.body.assign(plain.begin() + kHeadSize, plain.end());
  return content;
}

}  // namespace limpet
