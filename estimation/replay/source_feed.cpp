// SPDX-License-Identifier: MIT
#include "estimation/replay/source_feed.hpp"

#include <mrpt/obs/CObservation.h>

#include "estimation/navigation/measurement_source.hpp"
#include "estimation/navigation/navigator.hpp"

namespace limpet {

SourceFeed::SourceFeed(const std::vector<SourceRow>& rows, const Sources& sources,
                       Navigator& navigator)
    : rows_(rows), navigator_(navigator) {
  for (const auto& [name, factory] : sources) {
    auto source = factory->Make();
    use_.sources.push_back(
        {.name = name, .variable = source->variable(), .heard = 0, .senseless = 0, .counts = {}});
    static_cast<void>(navigator_.AddSource(std::move(source)));
  }
}

void SourceFeed::FeedUpTo(double t) {
  for (; next_ < rows_.size() && rows_[next_].t <= t; ++next_) {
    const SourceRow& row = rows_[next_];
    bool is_heard = false;
    for (std::size_t i = 0; i < use_.sources.size(); ++i) {
      ReplayedSource& one = use_.sources[i];
      if (one.variable != row.variable) continue;
      is_heard = true;
      ++one.heard;
      const int number = static_cast<int>(i);
      auto seen = navigator_.aiding().source(number).Observe(row.t, row.value);
      if (seen == nullptr) {
        ++one.senseless;
      } else {
        navigator_.AddObservation(number, std::move(seen));
      }
    }
    if (!is_heard) ++use_.unheard[row.variable];
  }
}

SourceUse SourceFeed::Use() const {
  SourceUse use = use_;
  use.after_end = static_cast<int>(rows_.size() - next_);
  for (std::size_t i = 0; i < use.sources.size(); ++i) {
    use.sources[i].counts = navigator_.aiding().counts(static_cast<int>(i));
  }
  return use;
}

}  // namespace limpet
