// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace limpet {

/// A process at one moment.
struct SampledProcess {
  pid_t pid = 0;
  std::string name;
  double resident_mib = 0.0;
  int descriptors = 0;  ///< open files and sockets
};

/// The children of `parent`, from /proc; those that have just ended are left out. Throws
/// std::runtime_error where /proc does not name children.
[[nodiscard]] std::vector<SampledProcess> ChildrenOf(pid_t parent);

}  // namespace limpet
