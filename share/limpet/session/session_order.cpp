// SPDX-License-Identifier: MIT
#include "limpet/session/session_order.hpp"

#include <algorithm>
#include <utility>

namespace limpet {

void SortSessions(std::vector<std::string>& sessions) {
  std::ranges::sort(sessions, {}, [](const std::string& name) {
    return std::pair(name == "discovery" ? 0 : name == "change" ? 1 : 2, name);
  });
}

}  // namespace limpet
