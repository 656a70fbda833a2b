// SPDX-License-Identifier: MIT
#include "limpet/report/open_change.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include <fmt/format.h>

namespace limpet {

std::string OpenText(const ChangeScore& change) {
  if (!change.posterior || change.decided == Status::kNotInspected) return "open";
  const StatusPosterior& p = *change.posterior;
  std::array<std::pair<double, const char*>, 4> may_be{{{p.confirmed, "confirmed"},
                                                        {p.removed, "removed"},
                                                        {p.appeared, "new"},
                                                        {p.nothing, "nothing"}}};
  std::ranges::sort(may_be, std::ranges::greater());
  return fmt::format("open: {} or {}", may_be[0].second, may_be[1].second);
}

}  // namespace limpet
