// SPDX-License-Identifier: MIT
#include "limpet/sharing/share_guard.hpp"

#include <algorithm>
#include <cmath>

#include <sodium.h>

#include "limpet/wire/little_endian.hpp"

namespace limpet {
namespace {

constexpr Seconds kFirstPause(0.25), kLongestPause(8.0);  ///< while there is no answer
constexpr Seconds kMeasureAgain(60.0);  ///< two crystals drift by some ms in that time
constexpr std::size_t kWordAt = sizeof(ShareRun);
constexpr std::size_t kQuestionSize = kWordAt + sizeof(std::uint64_t);

}  // namespace

ShareGuard::ShareGuard(const ShareKey& key, Settings settings, std::shared_ptr<Sealer> sealer,
                       ShareInstant now)
    : key_(key), settings_(settings), sealer_(std::move(sealer)), start_(now.steady) {}

Seconds ShareGuard::Oldest(ShareInstant now) const {
  constexpr Seconds kRounding(2e-6);  // of the times in a datagram
  return std::min(settings_.max_age, now.steady - start_) + kRounding;
}

ShareGuard::Sender* ShareGuard::Find(const ShareRun& run, ShareInstant now) {
  const auto known = senders_.find(run);
  if (known != senders_.end()) {
    return &known->second;
  }
  if (senders_.size() >= kMostSenders) {
    // One that has been quiet for so long has nothing left that is young enough to be repeated.
    const auto quiet = std::ranges::find_if(senders_, [&](const auto& entry) {
      return now.steady - entry.second.heard > kMeasureAgain + settings_.max_age;
    });
    if (quiet == senders_.end()) {
      return nullptr;
    }
    senders_.erase(quiet);
  }
  return &senders_[run];
}

ShareGuard::Verdict ShareGuard::Judge(ByteView datagram, std::uint64_t channel, ShareInstant now) {
  Verdict verdict;
  auto content = OpenSealed(key_, datagram);
  if (!content) {
    verdict.refusal = content.error();
  } else if (content->run == sealer_->run()) {
    verdict.refusal = ShareRefusal::kOwn;
  } else if (content->kind == SealedContent::Kind::kAnswer) {
    TakeAnswer(*content, now, verdict);
  } else if (content->kind != SealedContent::Kind::kData) {
    verdict.refusal = ShareRefusal::kMalformed;
  } else if (content->receiver != settings_.receiver &&
             (channel == 0 || content->receiver != channel)) {
    verdict.refusal = ShareRefusal::kElsewhere;
  } else {
    TakeData(std::move(*content), now, verdict);
  }
  return verdict;
}

void ShareGuard::TakeData(SealedContent content, ShareInstant now, Verdict& verdict) {
  Sender* sender = Find(content.run, now);
  if (sender == nullptr) {
    verdict.refusal = ShareRefusal::kOverflow;
    return;
  }
  sender->heard = now.steady;
  if (!sender->start || now.steady - sender->measured > kMeasureAgain) {
    Ask(*sender, content.run, now, verdict);
  }
  if (sender->start) {
    const Seconds age = now.steady - *sender->start - content.age_of_run;
    Settle(*sender, std::move(content), age, now, verdict);
    return;
  }
  const Seconds age = now.unix - content.unix;
  if (age <= Oldest(now) && age >= -settings_.max_age) {
    Settle(*sender, std::move(content), std::max(age, Seconds(0.0)), now, verdict);
  } else if (waiting_.size() >= kMostWaiting) {
    verdict.refusal = ShareRefusal::kOverflow;
  } else {
    waiting_.push_back({.content = std::move(content), .since = now.steady});
  }
}

void ShareGuard::Settle(Sender& sender, SealedContent content, Seconds age, ShareInstant now,
                        Verdict& verdict) {
  // Below zero only by what two crystals have drifted apart.
  if (age > Oldest(now) || age < -settings_.max_age) {
    verdict.refusal = ShareRefusal::kStale;
  } else if (!sender.window.IsNew(content.counter)) {
    verdict.refusal = ShareRefusal::kReplayed;
  } else {
    sender.window.Take(content.counter);
    verdict.bodies.push_back(std::move(content.body));
  }
}

void ShareGuard::Ask(Sender& sender, const ShareRun& run, ShareInstant now,
                     Verdict& verdict) const {
  if (sender.question && now.steady - sender.question->asked < sender.pause) {
    return;
  }
  sender.pause = sender.question ? std::min(sender.pause * 2.0, kLongestPause) : kFirstPause;
  sender.question = Question{.word = 0, .asked = now.steady};
  randombytes_buf(&sender.question->word, sizeof sender.question->word);
  ByteBuffer body(kQuestionSize);
  std::ranges::copy(run, body.begin());
  Put(body.data() + kWordAt, sender.question->word);
  verdict.reply = sealer_->Seal(SealedContent::Kind::kQuestion, 0, body, now);
}

void ShareGuard::TakeAnswer(const SealedContent& content, ShareInstant now, Verdict& verdict) {
  const auto found = senders_.find(content.run);
  const bool is_asked = found != senders_.end() && found->second.question &&
                        content.body.size() == sizeof(std::uint64_t) &&
                        found->second.question->word == Get<std::uint64_t>(content.body.data());
  if (!is_asked) {
    verdict.refusal = ShareRefusal::kReplayed;
    return;
  }
  Sender& sender = found->second;
  const Seconds asked = sender.question->asked;
  sender.question.reset();
  if (now.steady - asked > settings_.max_age) {
    verdict.refusal = ShareRefusal::kStale;
    return;
  }
  // It was asked before it answered: it started no earlier than that makes it.
  sender.start = asked - content.age_of_run;
  sender.measured = now.steady;
  std::vector<Waiting> others;
  for (Waiting& waiting : waiting_) {
    if (waiting.content.run != content.run) {
      others.push_back(std::move(waiting));
      continue;
    }
    const Seconds age = now.steady - *sender.start - waiting.content.age_of_run;
    Settle(sender, std::move(waiting.content), age, now, verdict);
  }
  waiting_ = std::move(others);
}

std::size_t ShareGuard::TakeGivenUp(ShareInstant now) {
  return std::erase_if(waiting_, [&](const Waiting& waiting) {
    return now.steady - waiting.since > settings_.max_age;
  });
}

std::optional<ByteBuffer> ShareGuard::Answer(ByteView datagram, ShareInstant now) {
  const auto content = OpenSealed(key_, datagram);
  const bool is_for_us = content && content->kind == SealedContent::Kind::kQuestion &&
                         content->body.size() == kQuestionSize &&
                         std::ranges::equal(ByteView(content->body).first(kWordAt), sealer_->run());
  if (!is_for_us) {
    return std::nullopt;
  }
  return sealer_->Seal(SealedContent::Kind::kAnswer, 0, ByteView(content->body).subspan(kWordAt),
                       now);
}

}  // namespace limpet
