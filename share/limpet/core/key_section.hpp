// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/params.hpp"

namespace limpet {

/// A section of a YAML file with its keys as declared; a section without a name is the file or the
/// section around it. Keys store into what was described.
struct KeySection {
  std::string name;
  std::vector<ParamSpec> keys;
};

}  // namespace limpet
