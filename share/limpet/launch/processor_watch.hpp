// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "limpet/core/units.hpp"
#include "limpet/topics/safety.hpp"

namespace limpet {

/// Time on processors that a process has had since its start.
struct ProcessorUsage {
  std::string name;
  pid_t pid = 0;
  Seconds used;
};

/// Which process is busiest: shares of a core, each a mean over the last twenty seconds or so,
/// since one decision of the helm may fill a core for a moment. Shares are of vehicle time: at warp
/// 10 ten times the work is done each second, and would not be at sea.
class ProcessorWatch {
 public:
  explicit ProcessorWatch(double warp) : warp_(warp) {}

  /// Processes as they are at `now`, real time, which does not go back. One under another pid than
  /// before is a new one.
  void Hear(const std::vector<ProcessorUsage>& processes, Seconds now);
  /// Nothing until two looks have shown how much a process used between them.
  [[nodiscard]] std::optional<ProcessorLoad> busiest() const;

 private:
  struct Kept {
    ProcessorUsage use;
    std::optional<double> share;  ///< of a core
  };
  double warp_;
  std::vector<Kept> kept_;
  Seconds heard_;
};

}  // namespace limpet
