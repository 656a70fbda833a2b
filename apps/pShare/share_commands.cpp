// SPDX-License-Identifier: MIT
// Routes that PSHARE_CMD asks for: any client of the database can, so they may open nothing that
// the block does not allow.
#include <cstdint>

#include <fmt/format.h>

#include "apps/pShare/share_app.hpp"
#include "limpet/wire/message_id.hpp"

namespace limpet {

void ShareApp::OnCommand(const MessagePtr& message) {
  const auto* text = std::get_if<std::string>(&message->value);
  if (message->id == message_id::kLatest && message->time < start_) {
    return;  // meant for a former self; of live ones the sender's clock may be wrong
  }
  const auto command = ParseShareCommand(text == nullptr ? "" : *text);
  const auto error = !command             ? std::optional(command.error())
                     : command->is_output ? AddOutputs(command->line, Origin::kCommand)
                                          : AddInputs(command->line, Origin::kCommand);
  if (!error) {
    ClearWarning(warnings::kBadCommand);
  } else {
    ++tally_.counts.commands;
    Warn(warnings::kBadCommand,
         fmt::format("{} from {}: {}", command_name_, message->source, error->text));
  }
}

std::optional<Error> ShareApp::WhyForbidden(const ShareSecurity& security) const {
  if (security.is_plain && !params_.allows_plain_routes) {
    return Error{
        fmt::format("is not opened: {} opens plain routes only where this app's block says "
                    "`allow_plain_routes = true`",
                    command_name_)};
  }
  if (!security.is_plain && !keys_.Has(security.key_file)) {
    return Error{
        fmt::format("is not opened: {} uses no key but those of this app's block", command_name_)};
  }
  return std::nullopt;
}

std::optional<Error> ShareApp::BoundInput(ShareInput& input) const {
  if (!input.security.is_plain) {
    return std::nullopt;
  }
  input.interface = input.interface.empty() ? params_.command_interface : input.interface;
  const bool is_allowed = params_.command_interface == "0.0.0.0" ||
                          input.interface == params_.command_interface ||
                          input.interface == "127.0.0.1";
  return is_allowed ? std::nullopt
                    : std::optional(Error{
                          fmt::format("is not opened: plain inputs of {} may listen at {} "
                                      "(`command_interface` of this app's block), not at {}",
                                      command_name_, params_.command_interface, input.interface)});
}

ShareGate::WhiteList ShareApp::ListOfBlock() const {
  ShareGate::WhiteList all;
  for (const Input& input : inputs_) {
    if (input.origin == Origin::kBlock && input.line.white_list.empty()) {
      return {};
    }
    if (input.origin == Origin::kBlock) {
      all.insert(all.end(), input.line.white_list.begin(), input.line.white_list.end());
    }
  }
  return all;
}

}  // namespace limpet
