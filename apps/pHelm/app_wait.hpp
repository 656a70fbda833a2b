// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace limpet {

/// The apps of `hold_on_app`, until each of them was seen among the database's clients.
class AppWait {
 public:
  /// Lines of names, several of one separated by commas.
  explicit AppWait(const std::vector<std::string>& lines);

  /// DB_CLIENTS: `pNav,pObstacleMgr,...`.
  void Hear(std::string_view clients);
  [[nodiscard]] bool is_over() const { return missing_.empty(); }
  /// `pObstacleMgr, pContactMgrV20`.
  [[nodiscard]] std::string MissingText() const;

 private:
  std::set<std::string, std::less<>> missing_;
};

}  // namespace limpet
