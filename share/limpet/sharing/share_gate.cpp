// SPDX-License-Identifier: MIT
#include "limpet/sharing/share_gate.hpp"

#include <algorithm>

#include "limpet/pubsub/wildcard.hpp"
#include "limpet/sharing/share_datagram.hpp"
#include "limpet/wire/message_conversion.hpp"

namespace limpet {
namespace {

struct RefusalWords {
  std::string_view name, meaning;
};

constexpr std::array<RefusalWords, kShareRefusals> kWords{{
    {"malformed", "it is no message"},
    {"not_sealed", "it is plain, and this input lets only sealed ones in"},
    {"sealed", "it is sealed, and this input has no key"},
    {"forged", "it is sealed with another key, or was changed on the way"},
    {"replayed", "it was taken before, or comes too late to tell"},
    {"former",
     "it is of a former session of its sender; or two senders have one name, or its clock "
     "went back"},
    {"own",
     "it is sealed in this app's own name: somebody sends it back, or two nodes have one "
     "name"},
    {"unlisted", "its variable is not on the white list"},
    {"looped", "its variable is shared from here too"},
    {"overflow", "too many came at once"},
}};

}  // namespace

std::string_view NameOf(ShareRefusal refusal) {
  return kWords.at(static_cast<std::size_t>(refusal)).name;
}
std::string_view MeaningOf(ShareRefusal refusal) {
  return kWords.at(static_cast<std::size_t>(refusal)).meaning;
}

Expected<Message, ShareRefusal> ShareGate::Admit(ByteView datagram) {
  ByteBuffer opened;
  if (opener_) {
    auto result = opener_->Open(datagram);
    if (!result) {
      return result.error();
    }
    opened = std::move(*result);
    datagram = opened;
  } else if (LooksSealed(datagram)) {
    return ShareRefusal::kSealed;
  }
  const auto message = DecodeShare(datagram);
  if (!message) {
    return ShareRefusal::kMalformed;
  }
  const bool is_listed =
      white_list_.empty() || std::ranges::any_of(white_list_, [&](const std::string& pattern) {
        return MatchesWildcard(pattern, message->key);
      });
  if (!is_listed) {
    return ShareRefusal::kUnlisted;
  }
  return MessageFrom(*message);
}

}  // namespace limpet
