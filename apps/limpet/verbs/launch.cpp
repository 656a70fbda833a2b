// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/launch.hpp"

#include <vector>

#include "limpet/launch/launch.hpp"

namespace limpet {

int RunLaunchVerb(std::span<const std::string> args) {
  return RunLaunch("limpet launch", std::vector<std::string>(args.begin(), args.end()));
}

}  // namespace limpet
