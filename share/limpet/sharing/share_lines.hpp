// SPDX-License-Identifier: MIT
// The `output` and `input` lines of pShare's block, of its command line and of PSHARE_CMD.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/core/units.hpp"
#include "limpet/sharing/share_address.hpp"

namespace limpet {

/// What a line says of how its datagrams travel; nothing: as the block says.
struct ShareSecurity {
  std::string key_file{};  ///< `key = FILE`
  bool is_plain = false;   ///< `plain = true`: MOOS's open datagrams
  bool operator==(const ShareSecurity&) const = default;
};

/// Fills in what the line leaves open from what the block says (`is_plain`: allow_plain_routes).
/// Plain routes are only for those who ask for them: an error if neither says anything.
[[nodiscard]] std::optional<Error> Settle(ShareSecurity& line, const ShareSecurity& block);

/// Says for whom a settled output's datagrams are sealed: the line, or else the block (`to`). An
/// error if neither does, unless it is plain or multicast.
struct ShareOutput;
[[nodiscard]] std::optional<Error> SettleReceiver(ShareOutput& output, const std::string& to);

/// One variable, or pattern of variables, to one address.
struct ShareOutput {
  std::string source;             ///< name, or pattern with `*` and `?`
  std::string app_pattern = "*";  ///< of a pattern: who first writes the variable
  std::string dest;  ///< name over there; of a pattern, a prefix, or `^` for what `*` stands for
  ShareAddress address;
  double max_hz = 0.0;              ///< at most that often; 0: every write
  std::optional<Seconds> duration;  ///< since the route was made; 0: what there is now, once
  std::optional<int> max_shares;
  ShareSecurity security;
  std::string to{};  ///< the receiver's community, or `community/app`; empty: as the block says

  [[nodiscard]] bool is_pattern() const {
    return source.find_first_of("*?") != std::string::npos || app_pattern != "*";
  }
};

/// Addresses to listen at, and what may come in.
struct ShareInput {
  std::vector<ShareAddress> addresses;
  std::vector<std::string> white_list;  ///< patterns of names; empty: all
  std::string interface {};             ///< address to bind to; empty: all, as MOOS does
  ShareSecurity security;
};

/// `src_name=X, dest_name=Y, route=a:1 & multicast_8, frequency=, duration=, max_shares=, key=,
/// to=, plain=`, or the short form `X->Y:a:1@2 & multicast_8, Z->a:1`. One output per route.
[[nodiscard]] Expected<std::vector<ShareOutput>> ParseShareOutputs(std::string_view line,
                                                                   const MulticastPlan& plan);

/// `route=localhost:9200 & multicast_9, white_list=A&B*, interface=, key=, plain=`, or the short
/// form `localhost:9200, multicast_9`.
[[nodiscard]] Expected<ShareInput> ParseShareInput(std::string_view line,
                                                   const MulticastPlan& plan);

/// `cmd=output,src_name=...` or `cmd=input,route=...`: which, and the line behind it.
struct ShareCommand {
  bool is_output = true;
  std::string line;
};
[[nodiscard]] Expected<ShareCommand> ParseShareCommand(std::string_view text);

}  // namespace limpet
