// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "apps/pShare/share_params.hpp"
#include "apps/pShare/share_tally.hpp"
#include "limpet/app/app.hpp"
#include "limpet/sharing/key_ring.hpp"
#include "limpet/sharing/output_book.hpp"
#include "limpet/sharing/share_gate.hpp"
#include "limpet/sharing/udp_sockets.hpp"

namespace limpet {

/// Shares variables with other communities over UDP: sealed with a key by default, or in MOOS's
/// open datagrams where the mission says so. Its sockets belong to real time: embedded it shares
/// nothing, and says so.
class ShareApp final : public App {
 public:
  using Params = ShareParams;

  ShareApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Attend(Seconds now) override;

  /// Port of each input that listens, in order.
  [[nodiscard]] std::vector<std::uint16_t> Ports() const;

 private:
  /// From where a line comes: a command may not open what the block does not allow.
  enum class Origin { kBlock, kCommand };
  struct Input {
    ShareAddress address;
    ShareInput line;
    Origin origin;
    std::optional<UdpSockets::Input> socket;  ///< nothing: cannot listen yet
    ShareGate gate;
  };

  /// Throws ConfigError with every problem.
  void ReadBlock();
  [[nodiscard]] std::optional<Error> AddOutputs(const std::string& line, Origin origin);
  [[nodiscard]] std::optional<Error> AddInputs(const std::string& line, Origin origin);
  [[nodiscard]] std::optional<Error> WhyForbidden(const ShareSecurity& security) const;
  /// Why a command may not open this plain input where it is to listen; one that names no
  /// interface gets the block's.
  [[nodiscard]] std::optional<Error> BoundInput(ShareInput& input) const;
  [[nodiscard]] std::optional<Error> AddInput(const ShareAddress& address, const ShareInput& line,
                                              Origin origin);
  [[nodiscard]] std::optional<Error> LoadKey(ShareSecurity& security, Origin origin);
  /// What inputs of commands must hold to, beside their own lists.
  [[nodiscard]] ShareGate::WhiteList ListOfBlock() const;
  void ListenAt(Input& input);
  void Hear(const ShareOutput& output);

  void OnMail(const MessagePtr& message);
  void OnCommand(const MessagePtr& message);
  void Send(const Message& message, const OutputBook::Due& due);
  void Take(const UdpSockets::Datagram& datagram, Seconds now);
  [[nodiscard]] bool IsLoop(const Message& message) const;
  void Refuse(ShareRefusal refusal, const std::string& from, Seconds now);
  void WatchRefusals(Seconds now);
  void PublishStatus(Seconds now);

  Params params_;
  Seconds start_;
  std::string command_name_;
  KeyRing keys_;
  OutputBook book_;
  std::vector<Input> inputs_;
  std::set<std::string> heard_;  ///< variables and patterns subscribed to
  MessagePtr last_mail_;         ///< it comes once for each subscription that matches
  ShareTally tally_;
  ShareCounts published_counts_;
  double overflow_seen_ = 0.0;
  std::optional<Seconds> last_status_;
  std::unique_ptr<UdpSockets> sockets_;  ///< last: its thread ends before what it wakes
};

/// Every problem of a block, with its lines.
[[nodiscard]] std::vector<ConfigProblem> CheckShareBlock(const ConfigBlock& block);

}  // namespace limpet
