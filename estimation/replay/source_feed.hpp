// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "estimation/navigation/aiding_sources.hpp"
#include "estimation/navigation/source_factory.hpp"
#include "estimation/replay/sensor_stream.hpp"

namespace limpet {

class Navigator;

/// What became of a source's rows.
struct ReplayedSource {
  std::string name, variable;
  int heard = 0;
  int senseless = 0;  ///< of these, values that the source cannot read
  SourceCounts counts;
};

struct SourceUse {
  std::vector<ReplayedSource> sources;
  std::map<std::string, int> unheard;  ///< rows by variable that no source hears
  int after_end = 0;                   ///< rows later than the last one of the other sensors
};

/// Hands the rows of further sensors to the navigator in order of time. `rows` and `navigator` must
/// outlive it, and no measurement may have come to the navigator.
class SourceFeed {
 public:
  using Sources = std::vector<std::pair<std::string, std::shared_ptr<const SourceFactory>>>;
  SourceFeed(const std::vector<SourceRow>& rows, const Sources& sources, Navigator& navigator);
  /// Those measured up to `t` [s].
  void FeedUpTo(double t);
  [[nodiscard]] SourceUse Use() const;

 private:
  const std::vector<SourceRow>& rows_;
  Navigator& navigator_;
  std::size_t next_ = 0;
  SourceUse use_;
};

}  // namespace limpet
