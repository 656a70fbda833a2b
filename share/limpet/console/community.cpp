// SPDX-License-Identifier: MIT
#include "limpet/console/community.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "limpet/app/run_app.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/wire/message_conversion.hpp"
#include "limpet/wire/message_id.hpp"

namespace limpet {
namespace {

constexpr Seconds kMailSlice(0.05);  ///< how soon a signal or a change of state is noticed
constexpr std::size_t kMostMail = 200'000;
constexpr std::size_t kMostBytes = std::size_t{256} << 20U;

std::size_t SizeOf(const WireMessage& message) {
  return message.text.size() + message.key.size() + message.source.size() + 128;
}

}  // namespace

Community::Community(const CommunityAddress& address, const std::string& name)
    : address_(address), name_(address.name.empty() ? name : address.name) {
  TcpClientOptions options{.host = address.host,
                           .port = address.port,
                           .name = name_,
                           .learns_warp = true,
                           .on_mail = [this](const WireMessage& message) { Add(message); },
                           .on_state = nullptr};
  client_ = std::make_unique<TcpClient>(std::move(options));
  Join();
}

void Community::Join() {
  const Seconds start = SteadyTime();
  const std::string place = address_.Text();
  while (client_->state() != TcpClient::State::kConnected) {
    const Seconds waited = SteadyTime() - start;
    const std::string trouble = client_->trouble();
    if (client_->state() == TcpClient::State::kRefused) {
      throw NoCommunity(fmt::format("the community at {} refuses us: {}", place, trouble));
    }
    if (EndIsRequested()) {
      throw NoCommunity(fmt::format("interrupted while joining {}", place));
    }
    if (!trouble.empty() && waited >= address_.wait) {
      throw NoCommunity(
          fmt::format("no community at {} ({}); start one with `limpet launch <mission.moos>`, or "
                      "say where it is with --host and --port",
                      place, trouble));
    }
    if (waited >= std::max(address_.wait, address_.patience)) {
      throw NoCommunity(
          fmt::format("{} does not answer as a MOOS database does; is it the right --host and "
                      "--port?",
                      place));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

void Community::Add(const WireMessage& message) {
  const std::size_t size = SizeOf(message);
  const std::lock_guard lock(mutex_);
  if (inbox_.size() >= kMostMail || inbox_bytes_ + size > kMostBytes) {
    ++lost_;
    return;
  }
  inbox_.push_back({MessageFrom(message), client_->Now()});
  inbox_bytes_ += size;
  arrival_.notify_one();
}

void Community::Watch(const std::string& pattern) {
  client_->SubscribeWildcard(
      {.app_pattern = "*", .variable_pattern = pattern, .interval = Seconds(0.0)});
}

std::vector<Mail> Community::TakeMail(Seconds wait) {
  std::unique_lock lock(mutex_);
  if (wait.value() > 0.0) {
    arrival_.wait_for(lock, std::chrono::duration<double>(wait.value()),
                      [this] { return !inbox_.empty(); });
  }
  std::vector<Mail> mail;
  mail.swap(inbox_);
  inbox_bytes_ = 0;
  return mail;
}

std::optional<std::vector<Mail>> Community::Settle() {
  const Seconds deadline = SteadyTime() + address_.patience;
  client_->Request("VAR_SUMMARY");
  std::vector<Mail> heard;
  while (SteadyTime() < deadline && !EndIsRequested()) {
    std::vector<Mail> mail = TakeMail(kMailSlice);
    const bool is_answered = std::ranges::any_of(mail, [](const Mail& piece) {
      return piece.message.id == message_id::kAnswer && piece.message.name == "VAR_SUMMARY";
    });
    std::ranges::move(mail, std::back_inserter(heard));
    if (is_answered) {
      return heard;
    }
  }
  return std::nullopt;
}

std::uint64_t Community::lost() const {
  const std::lock_guard lock(mutex_);
  return lost_;
}

std::string OwnName(const std::string& tool) { return fmt::format("{}_{}", tool, ::getpid()); }

}  // namespace limpet
