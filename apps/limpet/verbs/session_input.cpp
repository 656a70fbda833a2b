// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/session_input.hpp"

#include <fmt/format.h>

#include "limpet/session/cut_session.hpp"

namespace limpet {

SavedSession OpenSession(const std::string& folder, const std::string& what) {
  if (const auto note = CutNote(folder)) fmt::print(stderr, "note: {}\n", *note);
  return LoadSavedSession(folder, what);
}

}  // namespace limpet
