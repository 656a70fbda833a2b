// SPDX-License-Identifier: MIT
#include "apps/pShare/share_app.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "limpet/core/clock.hpp"
#include "limpet/sharing/share_datagram.hpp"
#include "limpet/wire/message_conversion.hpp"

namespace limpet {
namespace {

constexpr Seconds kStatusPeriod(1.0);
constexpr Seconds kSavePeriod(5.0);  ///< real time; what a kill makes us forget

std::string SenderName(const AppContext& context, const ShareParams& params) {
  return params.sender.empty() ? context.Global("Community") + "/" + context.name : params.sender;
}

std::string CommandName(std::string app) {
  std::ranges::transform(app, app.begin(), [](unsigned char letter) {
    return static_cast<char>(std::toupper(letter));
  });
  return app + "_CMD";
}

std::string WarningOf(ShareRefusal refusal) { return fmt::format("REFUSED_{}", NameOf(refusal)); }

}  // namespace

ShareApp::ShareApp(const AppContext& context, const Params& params)
    : App(context),
      params_(params),
      start_(now()),
      command_name_(CommandName(context.name)),
      keys_(context.mission_folder, SenderName(context, params), UnixTime()) {
  if (!context.runs_live) {
    Warn("NOT_LIVE", "shares nothing: its sockets belong to real time; use limpet launch");
    return;
  }
  sockets_ = std::make_unique<UdpSockets>([link = context.link] { link->Wake(); });
  ReadBlock();
  SubscribeRaw(command_name_, [this](const MessagePtr& message) { OnCommand(message); });
  SaveMemory();  // the new epoch at least: it must never be used again
}

void ShareApp::ReadBlock() {
  const SourceLine where{.file = context().mission_file.string(), .line = 0};
  if (!params_.key_file.empty()) {
    if (const auto channel = keys_.Load(params_.key_file); !channel) {
      throw ConfigError({where, "key_file", channel.error().text});
    }
  }
  std::vector<ConfigProblem> problems;
  for (const std::string& line : params_.outputs) {
    if (const auto error = AddOutputs(line)) {
      problems.push_back({where, "output", fmt::format("`{}` {}", line, error->text)});
    }
  }
  for (const std::string& line : params_.inputs) {
    if (const auto error = AddInputs(line)) {
      problems.push_back({where, "input", fmt::format("`{}` {}", line, error->text)});
    }
  }
  if (!problems.empty()) {
    throw ConfigError(problems);
  }
}

void ShareApp::SaveMemory() {
  last_save_ = SteadyTime();
  if (const auto error = keys_.Save()) {
    Warn("NO_MEMORY", error->text + "; after a restart old datagrams could be repeated");
  } else {
    ClearWarning("NO_MEMORY");
  }
}

void ShareApp::Finish(Seconds) { SaveMemory(); }

std::vector<std::uint16_t> ShareApp::Ports() const {
  std::vector<std::uint16_t> ports;
  for (const Input& input : inputs_) {
    if (input.socket) {
      ports.push_back(sockets_->PortOf(*input.socket));
    }
  }
  return ports;
}

std::optional<Error> ShareApp::LoadKey(ShareSecurity& security) {
  if (auto error = Settle(security, params_.Security())) {
    return error;
  }
  if (security.is_plain) {
    Warn("PLAIN_ROUTES", "some routes are open: anybody on the network can read and forge them");
    return std::nullopt;
  }
  const auto channel = keys_.Load(security.key_file);
  return channel ? std::nullopt : std::optional(channel.error());
}

std::optional<Error> ShareApp::AddOutputs(const std::string& line) {
  auto outputs = ParseShareOutputs(line, params_.Multicast());
  if (!outputs) {
    return outputs.error();
  }
  for (ShareOutput& output : *outputs) {
    if (auto error = LoadKey(output.security)) {
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

std::optional<Error> ShareApp::AddInputs(const std::string& line) {
  auto input = ParseShareInput(line, params_.Multicast());
  if (!input) {
    return input.error();
  }
  if (auto error = LoadKey(input->security)) {
    return error;
  }
  for (const ShareAddress& address : input->addresses) {
    if (auto error = AddInput(address, *input)) {
      return error;
    }
  }
  return std::nullopt;
}

std::optional<Error> ShareApp::AddInput(const ShareAddress& address, const ShareInput& line) {
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
  std::shared_ptr<Opener> opener;
  if (!line.security.is_plain) {
    opener = keys_.Load(line.security.key_file)->opener;
  }
  inputs_.push_back({.address = address,
                     .line = line,
                     .socket = std::nullopt,
                     .gate = ShareGate(std::move(opener), line.white_list)});
  ListenAt(inputs_.back());
  return std::nullopt;
}

void ShareApp::ListenAt(Input& input) {
  const std::string warning = "CANNOT_LISTEN_" + std::to_string(input.address.port);
  const auto socket = sockets_->Listen(input.address, input.line.interface);
  if (!socket) {
    Warn(warning, socket.error().text);
    return;
  }
  input.socket = *socket;
  input.address.port = sockets_->PortOf(*socket);
  ClearWarning(warning);
}

void ShareApp::OnCommand(const MessagePtr& message) {
  const auto* text = std::get_if<std::string>(&message->value);
  constexpr std::int32_t kLatestId = -1;  // of what is sent because somebody registered
  if (message->id == kLatestId && message->time < start_) {
    return;  // meant for a former self; of live ones the sender's clock may be wrong
  }
  const auto command = ParseShareCommand(text == nullptr ? "" : *text);
  const auto error = !command             ? std::optional(command.error())
                     : command->is_output ? AddOutputs(command->line)
                                          : AddInputs(command->line);
  ClearWarning("BAD_COMMAND");
  if (error) {
    Warn("BAD_COMMAND", fmt::format("{} from {}: {}", command_name_, message->source, error->text));
  }
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
    Warn("TOO_LARGE_" + message.name, bytes.error().text);
    return;
  }
  if (!due.security.is_plain) {
    bytes = keys_.Load(due.security.key_file)->sealer->Seal(*bytes);
  }
  const std::string warning = "UNSENT_" + due.address.Text();
  if (const auto error = sockets_->Send(due.address, *bytes)) {
    ++tally_.counts.unsent;
    Warn(warning, error->text);
    return;
  }
  ++tally_.counts.sent;
  ClearWarning(warning);
}

void ShareApp::Attend(Seconds now) {
  if (sockets_) {
    for (const UdpSockets::Datagram& datagram : sockets_->Take()) {
      Take(datagram, now);
    }
  }
}

void ShareApp::Take(const UdpSockets::Datagram& datagram, Seconds now) {
  const auto input = std::ranges::find_if(
      inputs_, [&datagram](const Input& each) { return each.socket == datagram.input; });
  const auto message = input->gate.Admit(datagram.bytes);
  if (!message) {
    Refuse(message.error(), fmt::format("{} at {}", datagram.sender.Text(), input->address.Text()),
           now);
  } else if (IsLoop(*message)) {
    Refuse(ShareRefusal::kLooped, "", now);
  } else {
    ++tally_.counts.taken;
    context().link->Forward(*message);
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
  if (SteadyTime() - last_save_ > kSavePeriod) {
    SaveMemory();
  }
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
