// SPDX-License-Identifier: MIT
#include "limpet/planning/search_term.hpp"

namespace limpet {

double WorthAlong(const DubinsPath& path, const SearchTerm& term) {
  PathEvents all(term.event_count());
  TermEvents events(all, 0);
  PathStep step{.from = path.start(), .motion = {}};
  double worth = 0.0;
  for (const PathSegment& segment : path.segments()) {
    step.motion = segment;
    worth += term.Worth(step, events);
    step.from = Advance(step.from, segment);
    step.before += segment.length;
  }
  return worth;
}

}  // namespace limpet
