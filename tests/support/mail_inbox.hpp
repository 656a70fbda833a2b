// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "limpet/wire/message_conversion.hpp"

namespace limpet {

/// Mail of one client, with a wait that ends as soon as it has come.
class MailInbox {
 public:
  void Add(const WireMessage& message) {
    const std::lock_guard lock(mutex_);
    mail_.push_back(MessageFrom(message));
    arrival_.notify_all();
  }
  /// True once a message with that text has come.
  bool AwaitText(const std::string& text) {
    std::unique_lock lock(mutex_);
    return arrival_.wait_for(lock, std::chrono::seconds(5), [&] {
      return std::ranges::any_of(mail_, [&text](const Message& message) {
        const auto* value = std::get_if<std::string>(&message.value);
        return value != nullptr && *value == text;
      });
    });
  }
  /// True once a message satisfies `is_it`.
  template <class Condition>
  bool AwaitThat(Condition is_it) {
    std::unique_lock lock(mutex_);
    return arrival_.wait_for(lock, std::chrono::seconds(5),
                             [&] { return std::ranges::any_of(mail_, is_it); });
  }
  /// The first message of that name, once it is there.
  std::optional<Message> Await(const std::string& name,
                               std::chrono::milliseconds longest = std::chrono::seconds(5)) {
    std::unique_lock lock(mutex_);
    std::optional<Message> found;
    arrival_.wait_for(lock, longest, [&] {
      for (const Message& message : mail_) {
        if (message.name == name && !found) {
          found = message;
        }
      }
      return found.has_value();
    });
    return found;
  }

 private:
  std::mutex mutex_;
  std::condition_variable arrival_;
  std::vector<Message> mail_;
};

}  // namespace limpet
