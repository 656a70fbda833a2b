// SPDX-License-Identifier: MIT
#include "limpet/pubsub/value_keeper.hpp"

#include <algorithm>

namespace limpet {
namespace {

constexpr double kShortestPause = 1.0;             ///< between values of one variable, mean [s]
constexpr double kBurst = 4.0;                     ///< values of one that has paused
constexpr double kBytesPerSecond = 64.0 * 1024.0;  ///< of one variable
constexpr std::size_t kLeastLimit = std::size_t{64} << 10;

}  // namespace

ValueKeeper::ValueKeeper(int descriptor, std::size_t limit, Broker& broker)
    : broker_(broker), file_(descriptor, std::max(limit, kLeastLimit)) {
  broker_.Restore(file_.Load(), broker_.started());
  broker_.ListNews();
  RewriteAll();
}

void ValueKeeper::Keep(Seconds now) {
  if (clears_ != broker_.clears()) {
    clears_ = broker_.clears();
    RewriteAll();
  }
  for (const Router::Variable variable : broker_.news()) {
    if (!KeepOne(variable, now)) {
      waiting_.push_back(variable);
    }
  }
  broker_.news().clear();
}

void ValueKeeper::KeepWaiting(Seconds now) {
  std::erase_if(waiting_, [&](Router::Variable variable) { return KeepOne(variable, now); });
}

/// False if it is to be kept later.
bool ValueKeeper::KeepOne(Router::Variable variable, Seconds now) {
  next_.resize(std::max<std::size_t>(next_.size(), variable + 1));
  const Seconds due = next_[variable];
  if (now < due) {
    return false;
  }
  const ByteView message = broker_.TakeNewsOf(variable);
  if (message.empty() || message.size() > kLargestValue) {
    return true;
  }
  const double pause =
      std::max(kShortestPause, static_cast<double>(message.size()) / kBytesPerSecond);
  // A pause for each value, those of a burst on credit.
  next_[variable] = std::max(due, now - Seconds((kBurst - 1.0) * pause)) + Seconds(pause);
  if (!file_.Append(message)) {
    RewriteAll();
  }
  return true;
}

/// What is latest now, as far as half the room goes: the other half is for what follows, so that
/// rewriting stays rare.
void ValueKeeper::RewriteAll() {
  ByteBuffer all;
  for (Router::Variable variable = 0; variable < broker_.router().variable_count(); ++variable) {
    const ByteView message = broker_.StoredOf(variable);
    if (message.size() <= kLargestValue && all.size() + message.size() <= file_.limit() / 2) {
      all.insert(all.end(), message.begin(), message.end());
    }
  }
  static_cast<void>(file_.Rewrite(all));
}

}  // namespace limpet
