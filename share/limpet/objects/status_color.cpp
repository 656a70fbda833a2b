// SPDX-License-Identifier: MIT
#include "limpet/objects/status_color.hpp"

namespace limpet {

std::optional<StatusColor> ColorOf(Status status) {
  switch (status) {
    case Status::kConfirmed:
      return StatusColor{"#009e73", "green", 0, 158, 115};
    case Status::kRemoved:
      return StatusColor{"#d55e00", "orangered", 213, 94, 0};
    case Status::kNew:
      return StatusColor{"#0072b2", "dodgerblue", 0, 114, 178};
    case Status::kMoved:
      return StatusColor{"#cc79a7", "magenta", 204, 121, 167};
    case Status::kUncertain:
    case Status::kNotInspected:
    case Status::kNothing:
      break;
  }
  return std::nullopt;
}

}  // namespace limpet
