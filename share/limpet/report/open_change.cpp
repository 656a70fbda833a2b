// SPDX-License-Identifier: MIT
#include "limpet/report/open_change.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include <fmt/format.h>

namespace limpet {

std::string OpenText(const ChangeScore& change) {
  if (!change.posterior || change.decided == Status::kNotInspected) return "open";
  std::array<StatusPosterior::Share, 4> may_be = change.posterior->shares();
  std::ranges::stable_sort(may_be, std::ranges::greater(), &StatusPosterior::Share::probability);
  return fmt::format("open: {} or {}", NameOf(may_be[0].status), NameOf(may_be[1].status));
}

}  // namespace limpet
