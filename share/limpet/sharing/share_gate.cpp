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
    {"old_version",
     "it is sealed as Limpet did before: both sides need the same version of Limpet"},
    {"forged", "it is sealed with another key, or was changed on the way"},
    {"elsewhere",
     "it is sealed for another receiver: its sender's `to` must be this community's name"},
    {"stale",
     "it is older than max_age_s, or than this app; or its sender's clock is off and it does not "
     "answer when asked for the time"},
    {"replayed", "it was taken before, or comes too late to tell"},
    {"own", "this app sealed it: somebody sends it back"},
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

ShareAdmission ShareGate::Admit(ByteView datagram, ShareInstant now) {
  ShareAdmission admission;
  if (!guard_) {
    if (LooksSealed(datagram)) {
      admission.refusals.push_back(ShareRefusal::kSealed);
    } else {
      AdmitPlain(datagram, admission);
    }
    return admission;
  }
  ShareGuard::Verdict verdict = guard_->Judge(datagram, channel_, now);
  if (verdict.refusal) {
    admission.refusals.push_back(*verdict.refusal);
  }
  for (const ByteBuffer& body : verdict.bodies) {
    AdmitPlain(body, admission);
  }
  admission.reply = std::move(verdict.reply);
  return admission;
}

void ShareGate::AdmitPlain(ByteView datagram, ShareAdmission& admission) const {
  const auto message = DecodeShare(datagram);
  if (!message) {
    admission.refusals.push_back(ShareRefusal::kMalformed);
    return;
  }
  const auto holds = [&](const WhiteList& list) {
    return list.empty() || std::ranges::any_of(list, [&](const std::string& pattern) {
             return MatchesWildcard(pattern, message->key);
           });
  };
  if (std::ranges::all_of(white_lists_, holds)) {
    admission.messages.push_back(MessageFrom(*message));
  } else {
    admission.refusals.push_back(ShareRefusal::kUnlisted);
  }
}

}  // namespace limpet
