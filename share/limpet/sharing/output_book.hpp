// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/core/units.hpp"
#include "limpet/sharing/share_lines.hpp"

namespace limpet {

/// Which writes go where, and under which name: fixed routes by variable, patterns that make a
/// fixed route of each variable they meet, rates, durations and counts. All times are MOOS time.
class OutputBook {
 public:
  static constexpr std::size_t kMostRoutes = 10'000;

  /// One datagram to be sent.
  struct Due {
    std::string dest;
    ShareAddress address;
    ShareSecurity security;
    std::string to{};  ///< as ShareOutput's
  };

  enum class Added { kNew, kRenewed, kRefused };
  /// Enters a route, or starts an equal one anew. Refused if there are too many.
  Added Add(const ShareOutput& output, Seconds now);
  /// What a write asks for; counts it as shared.
  [[nodiscard]] std::vector<Due> TakeDue(const Message& message, Seconds now);
  /// True if a line, not a pattern, names the variable: such a name is not taken from afar, or two
  /// communities that share it would echo each other for ever.
  [[nodiscard]] bool IsNamed(std::string_view variable) const;
  /// True if a pattern shares the variable.
  [[nodiscard]] bool IsMatched(std::string_view variable) const;
  /// `X->Y:host:port & Z:224.1.1.11:24468:multicast_8, ...`: of the routes still in force.
  [[nodiscard]] std::string Summary(Seconds now) const;

 private:
  struct Route {
    ShareOutput output;
    Seconds made;
    int shares = 0;
    bool is_from_pattern = false;
    std::optional<Seconds> last;
    [[nodiscard]] bool IsOver(Seconds now) const;
    [[nodiscard]] bool IsDue(Seconds now) const;
  };
  /// The equal route, or nullptr.
  [[nodiscard]] static Route* Find(std::vector<Route>& routes, const ShareOutput& output);
  Added AddFixed(const ShareOutput& output, bool is_from_pattern, Seconds now);
  void MeetPatterns(const Message& message, Seconds now);

  std::map<std::string, std::vector<Route>, std::less<>> fixed_;  ///< by variable
  std::vector<Route> patterns_;
  std::size_t count_ = 0;
};

}  // namespace limpet
