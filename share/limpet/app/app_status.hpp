// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "limpet/app/live_link.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// What this process has used of the machine.
struct ProcessUse {
  Seconds cpu;  ///< since its start
  std::int64_t memory_kb = 0, memory_max_kb = 0;
};
[[nodiscard]] ProcessUse UseOfThisProcess();

/// `<APP>_STATUS` of a live process, in the form that MOOS's own apps post.
class AppStatus {
 public:
  AppStatus(const std::string& name, Seconds started);

  [[nodiscard]] const std::string& variable() const { return variable_; }
  /// The processor load is that since the last call.
  [[nodiscard]] std::string Text(std::int64_t iteration, const LiveLink& link);
  /// Status of a process that is no client: `now` is its MOOS time.
  [[nodiscard]] std::string Text(std::int64_t iteration, Seconds now);

 private:
  [[nodiscard]] std::string Text(std::int64_t iteration, Seconds now,
                                 const std::set<std::string>& published,
                                 const std::set<std::string>& subscribed);

  std::string name_;
  std::string variable_;
  Seconds started_;  ///< MOOS time
  Seconds last_cpu_;
  Seconds last_time_;  ///< steady
};

}  // namespace limpet
