// SPDX-License-Identifier: MIT
#include "apps/pShare/share_app.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "apps/pShare/share_warnings.hpp"
#include "limpet/core/letter_case.hpp"
#include "limpet/sharing/share_datagram.hpp"
#include "limpet/wire/message_conversion.hpp"

namespace limpet {
namespace {

constexpr Seconds kStatusPeriod(1.0);

std::string OwnName(const AppContext& context, const ShareParams& params) {
  return params.sender.empty() ? context.Global("Community") + "/" + context.name : params.sender;
}

std::string CommandName(std::string_view app) { return UpperCase(app) + "_CMD"; }

WarningId WarningOf(ShareRefusal refusal) {
  return warnings::kRefusedDatagrams.Of(NameOf(refusal));
}

}  // namespace

ShareApp::ShareApp(const AppContext& context, const Params& params)
    : App(context),
      params_(params),
      start_(now()),
      command_name_(CommandName(context.name)),
      keys_(context.mission_folder,
            {.receiver = ShareReceiverId(OwnName(context, params)), .max_age = params.max_age}) {
  if (!context.runs_live) {
    Warn(warnings::kNotLive, "shares nothing: its sockets belong to real time; use limpet launch");
    return;
  }
  sockets_ = std::make_unique<UdpSockets>([link = context.link] { link->Wake(); });
  ReadBlock();
  SubscribeRaw(command_name_, [this](const MessagePtr& message) { OnCommand(message); });
}

void ShareApp::ReadBlock() {
  const SourceLine where{.file = context().mission_file.string(), .line = 0};
  if (!params_.key_file.empty()) {
    if (const auto channel = keys_.Load(params_.key_file, ShareInstant::Now()); !channel) {
      throw ConfigError({where, "key_file", channel.error().text});
    }
  }
  std::vector<ConfigProblem> problems;
  for (const std::string& line : params_.outputs) {
    if (const auto error = AddOutputs(line, Origin::kBlock)) {
      problems.push_back({where, "output", fmt::format("`{}` {}", line, error->text)});
    }
  }
  for (const std::string& line : params_.inputs) {
    if (const auto error = AddInputs(line, Origin::kBlock)) {
      problems.push_back({where, "input", fmt::format("`{}` {}", line, error->text)});
    }
  }
  if (!problems.empty()) {
    throw ConfigError(problems);
  }
}

std::vector<std::uint16_t> ShareApp::Ports() const {
  std::vector<std::uint16_t> ports;
  for (const Input& input : inputs_) {
    if (input.socket) {
      ports.push_back(sockets_->PortOf(*input.socket));
    }
  }
  return ports;
}

std::optional<Error> ShareApp::LoadKey(ShareSecurity& security, Origin origin) {
  if (auto error = Settle(security, params_.Security())) {
    return error;
  }
  if (auto error = origin == Origin::kCommand ? WhyForbidden(security) : std::nullopt) {
    return error;
  }
  if (security.is_plain) {
    Warn(warnings::kPlainRoutes,
         "some routes are open: anybody on the network can read and forge them");
    return std::nullopt;
  }
  const auto channel = keys_.Load(security.key_file, ShareInstant::Now());
  return channel ? std::nullopt : std::optional(channel.error());
}

std::optional<Error> ShareApp::AddOutputs(const std::string& line, Origin origin) {
  auto outputs = ParseShareOutputs(line, params_.Multicast());
  if (!outputs) {
    return outputs.error();
  }
  for (ShareOutput& output : *outputs) {
    auto error = LoadKey(output.security, origin);
    error = error ? error : SettleReceiver(output, params_.to);
    if (error) {
      return error;
    }
    const OutputBook::Added added = book_.Add(output, now());
    if (added == OutputBook::Added::kRefused) {
      return Error{fmt::format("is one route too many; at most {}", OutputBook::kMostRoutes)};
    }
    sockets_->Resolve(output.address);
    const bool wants_the_present = output.duration && output.duration->value() == 0.0;
    if (added == OutputBook::Added::kNew || wants_the_present) {
      Hear(output);
    }
  }
  return std::nullopt;
}

void ShareApp::Hear(const ShareOutput& output) {
  const std::string id =
      output.is_pattern() ? output.source + ":" + output.app_pattern : output.source;
  const auto on_mail = [this](const MessagePtr& message) { OnMail(message); };
  if (!heard_.insert(id).second) {
    if (!output.is_pattern()) {
      context().link->Subscribe(output.source, Seconds(0.0));  // again: the value there is now
    }
  } else if (output.is_pattern()) {
    SubscribeRaw(WildcardFilter{.app_pattern = output.app_pattern,
                                .variable_pattern = output.source,
                                .interval = Seconds(0.0)},
                 on_mail);
  } else {
    SubscribeRaw(output.source, on_mail);
  }
}

std::optional<Error> ShareApp::AddInputs(const std::string& line, Origin origin) {
  auto input = ParseShareInput(line, params_.Multicast());
  if (!input) {
    return input.error();
  }
  auto error = LoadKey(input->security, origin);
  error = error || origin == Origin::kBlock ? error : BoundInput(*input);
  if (error) {
    return error;
  }
  input->interface = input->interface.empty() ? "0.0.0.0" : input->interface;
  for (const ShareAddress& address : input->addresses) {
    error = AddInput(address, *input, origin);
    if (error) {
      return error;
    }
  }
  return std::nullopt;
}

std::optional<Error> ShareApp::AddInput(const ShareAddress& address, const ShareInput& line,
                                        Origin origin) {
  for (const Input& known : inputs_) {
    const bool is_same_place = address.port != 0 && known.address.port == address.port &&
                               known.address.channel == address.channel &&
                               known.line.interface == line.interface;
    if (!is_same_place) {
      continue;
    }
    // Brokers of routes repeat themselves.
    const bool is_repeated =
        known.line.white_list == line.white_list && known.line.security == line.security;
    return is_repeated
               ? std::nullopt
               : std::optional(Error{fmt::format(
                     "{} is listened to already, with another key or white list", address.Text())});
  }
  if (inputs_.size() >= UdpSockets::kMostInputs) {
    return Error{fmt::format("is one input too many; at most {}", UdpSockets::kMostInputs)};
  }
  std::shared_ptr<ShareGuard> guard;
  if (!line.security.is_plain) {
    guard = keys_.Load(line.security.key_file, ShareInstant::Now())->guard;
  }
  std::vector<ShareGate::WhiteList> lists{line.white_list};
  if (origin == Origin::kCommand) {
    lists.push_back(ListOfBlock());
  }
  const std::uint64_t channel = address.channel ? ShareChannelId(address.Text()) : 0;
  inputs_.push_back({.address = address,
                     .line = line,
                     .origin = origin,
                     .socket = std::nullopt,
                     .gate = ShareGate(std::move(guard), std::move(lists), channel)});
  ListenAt(inputs_.back());
  return std::nullopt;
}

void ShareApp::ListenAt(Input& input) {
  const WarningId warning = warnings::kCannotListen.Of(std::to_string(input.address.port));
  const auto socket = sockets_->Listen(input.address, input.line.interface);
  if (!socket) {
    Warn(warning, socket.error().text);
    return;
  }
  input.socket = *socket;
  input.address.port = sockets_->PortOf(*socket);
  ClearWarning(warning);
}

void ShareApp::OnMail(const MessagePtr& message) {
  const bool is_own_report = message->source == name() && !book_.IsNamed(message->name);
  if (message == last_mail_ || is_own_report) {
    return;
  }
  last_mail_ = message;
  for (const OutputBook::Due& due : book_.TakeDue(*message, now())) {
    Send(*message, due);
  }
}

void ShareApp::Send(const Message& message, const OutputBook::Due& due) {
  WireMessage wire = ViewOf(message);
  wire.key = due.dest;
  auto bytes = EncodeShare(wire);
  if (!bytes) {
    ++tally_.counts.too_large;
    Warn(warnings::kTooLarge.Of(message.name), bytes.error().text);
    return;
  }
  if (!due.security.is_plain) {
    const ShareInstant now = ShareInstant::Now();
    const std::uint64_t receiver =
        due.to.empty() ? ShareChannelId(due.address.Text()) : ShareReceiverId(due.to);
    bytes = keys_.Load(due.security.key_file, now)
                ->sealer->Seal(SealedContent::Kind::kData, receiver, *bytes, now);
  }
  if (const auto error = sockets_->Send(due.address, *bytes)) {
    ++tally_.counts.unsent;
    Warn(warnings::kUnsent.Of(due.address.Text()), error->text);
    return;
  }
  ++tally_.counts.sent;
  ClearWarning(warnings::kUnsent, due.address.Text());
  ClearWarning(warnings::kTooLarge, message.name);
}

void ShareApp::Attend(Seconds now) {
  if (sockets_) {
    for (const UdpSockets::Datagram& datagram : sockets_->Take()) {
      Take(datagram, now);
    }
  }
}

void ShareApp::Take(const UdpSockets::Datagram& datagram, Seconds now) {
  if (datagram.input == UdpSockets::kReplies) {
    if (const auto answer = keys_.Answer(datagram.bytes, ShareInstant::Now())) {
      sockets_->Reply(datagram, *answer);
    }
    return;
  }
  const auto input = std::ranges::find_if(
      inputs_, [&datagram](const Input& each) { return each.socket == datagram.input; });
  const ShareAdmission admission = input->gate.Admit(datagram.bytes, ShareInstant::Now());
  if (admission.reply) {
    sockets_->Reply(datagram, *admission.reply);
  }
  for (const ShareRefusal refusal : admission.refusals) {
    Refuse(refusal, fmt::format("{} at {}", datagram.sender.Text(), input->address.Text()), now);
  }
  for (const Message& message : admission.messages) {
    if (IsLoop(message)) {
      Refuse(ShareRefusal::kLooped, "", now);
    } else {
      ++tally_.counts.taken;
      context().link->Forward(message);
    }
  }
}

bool ShareApp::IsLoop(const Message& message) const {
  if (message.name == command_name_ || book_.IsNamed(message.name)) {
    return true;
  }
  const std::string own = context().Global("Community");
  return !own.empty() && message.community == own && book_.IsMatched(message.name);
}

void ShareApp::Refuse(ShareRefusal refusal, const std::string& from, Seconds now) {
  if (tally_.Note(refusal, now)) {
    Warn(WarningOf(refusal), fmt::format("a datagram from {}: {}", from, MeaningOf(refusal)));
  }
}

void ShareApp::WatchRefusals(Seconds now) {
  const auto overflow = static_cast<double>(sockets_->overflow());
  if (overflow > overflow_seen_) {
    tally_.Note(ShareRefusal::kOverflow, now, overflow - overflow_seen_);
    overflow_seen_ = overflow;
    Warn(WarningOf(ShareRefusal::kOverflow), std::string(MeaningOf(ShareRefusal::kOverflow)));
  }
  if (const std::size_t count = keys_.TakeGivenUp(ShareInstant::Now()); count > 0) {
    tally_.Note(ShareRefusal::kStale, now, static_cast<double>(count));
    Warn(WarningOf(ShareRefusal::kStale), std::string(MeaningOf(ShareRefusal::kStale)));
  }
  for (const ShareRefusal refusal : tally_.TakeSettled(now)) {
    ClearWarning(WarningOf(refusal));
  }
}

void ShareApp::Tick(Seconds now) {
  if (!sockets_ || (last_status_ && now - *last_status_ < kStatusPeriod)) {
    return;
  }
  last_status_ = now;
  for (Input& input : inputs_) {
    if (!input.socket) {
      ListenAt(input);
    }
  }
  WatchRefusals(now);
  PublishStatus(now);
}

void ShareApp::PublishStatus(Seconds now) {
  std::string inputs;
  for (const Input& input : inputs_) {
    if (input.socket) {
      inputs += (inputs.empty() ? "" : ",") + input.address.Text();
    }
  }
  Publish(topics::kShareOutputs, book_.Summary(now));
  Publish(topics::kShareInputs, inputs);
  if (!(tally_.counts == published_counts_)) {
    Publish(topics::kShareCounts, tally_.counts);
    published_counts_ = tally_.counts;
  }
}

}  // namespace limpet
